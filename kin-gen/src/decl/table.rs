//! The Markdown table.
//!
//! A row begins and ends with `|`, so two rows meet in `| |`; the header has no empty cell, so the first `| |` is its
//! end and fixes the number of columns; from there on it is enough to count bars. Lines are looked at only once the
//! count has gone wrong, to say which row is to blame and to go on with the next one: where lines are unknown, or all
//! tokens claim line 1 as in rust-analyzer, a right table reads the same and a wrong one gets a vaguer message.

use super::cursor::Cursor;
use super::lex::{Kind, Token};
use super::nearest::nearest;
use super::{Cell, Column, Content, MAX_ROWS, Row, Table, expr};
use crate::report::{Place, Report};

const COLUMNS: &str = "the columns are joint, alpha, a, d, theta and limits";

/// A table and whether all of its rows could be told apart.
pub(super) struct Read {
    pub(super) table: Table,
    pub(super) whole: bool,
}

/// Reads the table that starts at the next token, a bar.
pub(super) fn table(cursor: &mut Cursor<'_>, report: &mut Report) -> Read {
    let (bars, line) = region(cursor.rest());
    let mut tokens = &cursor.rest()[..bars];
    let mut head = header_end(tokens);
    let mut found = rows_by_count(&tokens[head..], bars_in(&tokens[..head]).saturating_sub(1));
    if !lines_agree(tokens, head) {
        found = None;
    }
    if found.is_none() {
        // A row that does not end with a bar takes the rest of its line with it.
        tokens = &cursor.rest()[..line];
        head = header_end(tokens);
    }
    let (header, body) = tokens.split_at(head);
    for _ in tokens {
        cursor.next();
    }
    let mut table = Table { columns: columns(header, report), rows: Vec::new(), place: place_of(header) };
    let (rows, mut whole) = match found {
        Some(rows) => (rows, true),
        None => rows_by_line(header, body, &table, report),
    };
    for row in rows {
        if is_dashes(row) {
            continue;
        }
        if is_header(row) {
            report.error_help(place_of(row), "the header of the table occurs twice", "remove this row");
            continue;
        }
        if table.rows.len() >= MAX_ROWS {
            report.error(place_of(row), format!("the table has more than {MAX_ROWS} rows"));
            whole = false;
            break;
        }
        let read = read_row(row, &table.columns, report);
        table.rows.push(read);
    }
    Read { table, whole }
}

fn is_bar(token: &Token) -> bool {
    token.is("|")
}

fn place_of(tokens: &[Token]) -> Place {
    match (tokens.first(), tokens.last()) {
        (Some(first), Some(last)) => Place { first: first.at, last: last.at },
        _ => Place::default(),
    }
}

/// The number of tokens up to the last bar before the next `;`, and up to the end of that bar's line.
fn region(tokens: &[Token]) -> (usize, usize) {
    let stop = tokens.iter().position(|t| t.is(";")).unwrap_or(tokens.len());
    let last = tokens[..stop].iter().rposition(is_bar).unwrap_or(0);
    if !lines_known(&tokens[..=last]) {
        return (last + 1, last + 1);
    }
    let rest = tokens[last + 1..stop].iter().take_while(|t| t.line == tokens[last].line).count();
    (last + 1, last + 1 + rest)
}

/// Just after the bar that ends the header.
fn header_end(tokens: &[Token]) -> usize {
    let boundary = tokens.windows(2).position(|pair| is_bar(&pair[0]) && is_bar(&pair[1]));
    let by_bars = boundary.map_or(tokens.len(), |at| at + 1);
    // An empty cell in the header looks like its end; where lines are known, the line shows it.
    if lines_known(tokens) {
        let line = tokens[0].line;
        let by_line = tokens.iter().position(|t| t.line != line).unwrap_or(tokens.len());
        if by_bars < by_line
            && tokens[..by_line].windows(2).filter(|p| is_bar(&p[0]) && is_bar(&p[1])).count() > 0
        {
            let rows_fit =
                rows_by_count(&tokens[by_bars..], bars_in(&tokens[..by_bars]).saturating_sub(1)).is_some();
            return if rows_fit { by_bars } else { by_line };
        }
    }
    by_bars
}

fn bars_in(tokens: &[Token]) -> usize {
    tokens.iter().filter(|t| is_bar(t)).count()
}

/// Whether the tokens stand on several lines and all of them are known.
fn lines_known(tokens: &[Token]) -> bool {
    let first = tokens.first().map_or(0, |t| t.line);
    tokens.iter().all(|t| t.line != 0) && tokens.iter().any(|t| t.line != first)
}

/// The rows as counting bars finds them; `None` if they do not fit.
fn rows_by_count(mut body: &[Token], columns: usize) -> Option<Vec<&[Token]>> {
    let mut rows = Vec::new();
    while !body.is_empty() {
        let at = row_length(body, columns)?;
        let (row, rest) = body.split_at(at);
        rows.push(row);
        body = rest;
    }
    Some(rows)
}

/// The number of tokens of the row that starts here.
fn row_length(body: &[Token], columns: usize) -> Option<usize> {
    if !body.first().is_some_and(is_bar) {
        return None;
    }
    let mut closing = body.iter().enumerate().filter(|(_, t)| is_bar(t)).map(|(i, _)| i);
    closing.nth(columns).map(|i| i + 1)
}

/// Whether no line contradicts the count: two wrong rows can make up for each other.
fn lines_agree(tokens: &[Token], head: usize) -> bool {
    let row = bars_in(&tokens[..head]);
    let mut lines = tokens.chunk_by(|a, b| a.line == b.line);
    let shaped = |line: &[Token]| line.first().is_some_and(is_bar) && line.last().is_some_and(is_bar);
    !lines_known(tokens) || !lines.clone().all(shaped) || lines.all(|line| bars_in(line).is_multiple_of(row))
}

/// The rows that can be saved after the count has gone wrong, with a message for each of the others.
fn rows_by_line<'a>(
    header: &[Token],
    body: &'a [Token],
    table: &Table,
    report: &mut Report,
) -> (Vec<&'a [Token]>, bool) {
    let columns = table.columns.len();
    let help = columns_help(table);
    let mut rows = Vec::new();
    if !lines_known(body) && header.last().map(|t| t.line) == body.first().map(|t| t.line) {
        // Without lines nobody can tell which row is to blame, only where it showed.
        let mut rest = body;
        while let Some(at) = row_length(rest, columns) {
            let (row, after) = rest.split_at(at);
            rows.push(row);
            rest = after;
        }
        // The last row that seemed to fit has probably swallowed a bar of the next one.
        rows.pop();
        let place = rest.first().or(body.last()).map_or(table.place, |t| t.at.into());
        report.error_help(
            place,
            format!("up to here a row does not have the header's {columns} cells"),
            help,
        );
        return (rows, false);
    }
    let mut number = 0;
    let mut whole = true;
    for line in body.chunk_by(|a, b| a.line == b.line) {
        let dashes = is_dashes(line);
        number += usize::from(!dashes);
        if let Some(found) = rows_by_count(line, columns) {
            rows.extend(found);
            continue;
        }
        whole = false;
        let label = if dashes { "the row of dashes".to_string() } else { row_label(line, table, number) };
        let place = place_of(line);
        if !line.first().is_some_and(is_bar) {
            report.error_help(
                place,
                format!("{label} does not begin with `|`"),
                "every row begins and ends with `|`",
            );
        } else if !line.last().is_some_and(is_bar) {
            report.error_help(
                place,
                format!("{label} does not end with `|`"),
                "every row begins and ends with `|`",
            );
        } else {
            let cells = bars_in(line) - 1;
            let plural = if cells == 1 { "cell" } else { "cells" };
            report.error_help(
                place,
                format!("{label} has {cells} {plural}, the header has {columns}"),
                help.clone(),
            );
        }
    }
    (rows, whole)
}

fn columns_help(table: &Table) -> String {
    let names: Vec<&str> = table.columns.iter().map(|(_, name)| name.as_str()).collect();
    format!(
        "each row has the cells {}; write 0 for a zero, only joint and limits may be empty",
        names.join(", ")
    )
}

/// `row J2`, or `row 3` of a nameless one.
fn row_label(row: &[Token], table: &Table, number: usize) -> String {
    let column = table.columns.iter().position(|(c, _)| *c == Column::Joint);
    let cell = column.and_then(|i| row.split(is_bar).nth(i + 1));
    match cell {
        Some([name]) if name.kind == Kind::Word => format!("row {}", name.text),
        _ => format!("row {number}"),
    }
}

fn is_dashes(row: &[Token]) -> bool {
    row.iter().all(|t| is_bar(t) || t.is("-") || t.is(":")) && row.iter().any(|t| t.is("-"))
}

/// Whether every cell is the name of a column.
fn is_header(row: &[Token]) -> bool {
    cells(row).iter().all(|(inside, _)| column(&text_of(inside)) != Column::Unknown)
}

fn text_of(tokens: &[Token]) -> String {
    tokens.iter().map(|t| t.text.as_str()).collect()
}

/// The cells between bars, each with the place of its tokens or, if empty, of the bar that closes it.
fn cells(row: &[Token]) -> Vec<(&[Token], Place)> {
    let mut cells = Vec::new();
    let mut start = 1;
    for (i, token) in row.iter().enumerate().skip(1) {
        if is_bar(token) {
            let inside = row.get(start..i).unwrap_or(&[]);
            cells.push((inside, if inside.is_empty() { token.at.into() } else { place_of(inside) }));
            start = i + 1;
        }
    }
    cells
}

fn columns(header: &[Token], report: &mut Report) -> Vec<(Column, String)> {
    let mut columns: Vec<(Column, String)> = Vec::new();
    for (inside, place) in cells(header) {
        let text = text_of(inside);
        let column = column(&text);
        if text.is_empty() {
            report.error_help(place, "a cell of the header is empty", COLUMNS);
        } else if column == Column::Unknown {
            unknown_column(&text, place, report);
        } else if let Some((_, earlier)) = columns.iter().find(|(c, _)| *c == column) {
            let also =
                if *earlier == text { String::new() } else { format!(", as `{earlier}` and as `{text}`") };
            report.error_help(place, format!("the column `{}` occurs twice{also}", column.header()), COLUMNS);
            columns.push((Column::Unknown, text));
            continue;
        }
        columns.push((column, text));
    }
    let unclear = columns.iter().any(|(c, _)| *c == Column::Unknown);
    for needed in [Column::Alpha, Column::A, Column::D, Column::Theta] {
        if !unclear && !columns.iter().any(|(c, _)| *c == needed) {
            let message = format!("the column `{}` is missing", needed.header());
            report.error_help(place_of(header), message, COLUMNS);
        }
    }
    columns
}

fn column(text: &str) -> Column {
    match text.to_lowercase().as_str() {
        "joint" | "i" | "frame" | "link" | "name" => Column::Joint,
        "alpha" | "alpha_i" => Column::Alpha,
        "a" | "a_i" | "r" | "r_i" => Column::A,
        "d" | "d_i" => Column::D,
        "theta" | "theta_i" => Column::Theta,
        "limits" => Column::Limits,
        _ => Column::Unknown,
    }
}

fn unknown_column(text: &str, place: Place, report: &mut Report) {
    let meant = match text.to_lowercase().as_str() {
        "alfa" | "twist" => Some("alpha"),
        "range" => Some("limits"),
        other => nearest(other, ["joint", "alpha", "theta", "limits", "frame", "link", "name"]),
    };
    let help = match meant {
        Some(near) => format!("did you mean `{near}`? {COLUMNS}"),
        None => COLUMNS.to_string(),
    };
    report.error_help(place, format!("`{text}` is not a column"), help);
}

fn read_row(row: &[Token], columns: &[(Column, String)], report: &mut Report) -> Row {
    let mut read = Vec::new();
    for ((inside, place), (column, _)) in cells(row).into_iter().zip(columns) {
        let content = content(inside, place, *column, report);
        read.push(Cell { content, place });
    }
    Row { cells: read, place: place_of(row) }
}

fn content(inside: &[Token], place: Place, column: Column, report: &mut Report) -> Content {
    match (column, inside) {
        (Column::Unknown, _) => Content::Bad,
        (_, []) => Content::Empty,
        (Column::Joint, [name]) if matches!(name.kind, Kind::Word | Kind::Number) => {
            Content::Name(name.text.clone())
        }
        (Column::Joint, _) => {
            report.error_help(place, "a joint's name is one word", "write `J1`, `shoulder_pan` or just `1`");
            Content::Bad
        }
        (Column::Limits, _) => limits(inside, place, report).unwrap_or(Content::Bad),
        _ => expr::whole(Cursor::new(inside, place), report).map_or(Content::Bad, Content::Value),
    }
}

/// `lo .. hi`.
fn limits(inside: &[Token], place: Place, report: &mut Report) -> Option<Content> {
    let mut cursor = Cursor::new(inside, place);
    let low = cursor.until(|t| t.is("."));
    if !cursor.are(&[".", "."]) || low.is_empty() || cursor.len() < 3 {
        report.error_help(
            place,
            "limits are written `lowest .. highest`",
            "write `-170 .. 170`, or leave the cell empty",
        );
        return None;
    }
    cursor.next();
    cursor.next();
    cursor.eat("=");
    let low = expr::whole(low, report);
    let high = expr::whole(cursor, report);
    Some(Content::Range(low?, high?))
}
