//! The nearest known name: the remedy for most misspellings.

/// The candidate that fewest edits turn into `word`, if they are few; the first one where several are as near.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let mut best: Option<(usize, &str)> = None;
    // Short names are near to everything: two thirds of the letters must be right.
    let allowed = ((word.chars().count() + 1) / 3).min(3);
    for candidate in candidates {
        let edits = distance(&word.to_lowercase(), &candidate.to_lowercase());
        if edits <= allowed && best.is_none_or(|(least, _)| edits < least) {
            best = Some((edits, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Insertions, deletions, substitutions and swaps of neighbours (optimal string alignment). Another digit counts
/// twice: `l3` is no misspelling of `l2`.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(40).collect(), b.chars().take(40).collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let substitution = match (a[i - 1], b[j - 1]) {
                (x, y) if x == y => 0,
                (x, y) if x.is_ascii_digit() && y.is_ascii_digit() => 2,
                _ => 1,
            };
            let mut least = (rows[i - 1][j - 1] + substitution).min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}
