//! The cross-section of a workspace: the half-plane through axis 1, with the curves on which the arm is singular.
//!
//! The curves are computed, not sampled: the determinant of the position Jacobian is followed to zero over the angles of
//! joints 2 and 3, each crossing of a grid line bisected to the last bit, and carried into space. Which of them bound the
//! workspace is decided by counting solutions on both sides.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use crate::model::{Body, Model};
use crate::plot::Ticks;
use crate::svg::{Anchor, Svg};
use crate::view::{Point, along, dot};

/// What a curve separates.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Edge {
    /// Reachable space from what lies beyond the arm's length.
    Outer,
    /// Reachable space from a void inside.
    Inner,
    /// Nothing: the arm is singular there, and the number of solutions may change.
    Singular,
}

/// A piece of curve: (distance from axis 1, height) in the arm's unit.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// What it separates.
    pub edge: Edge,
    /// Its course.
    pub points: Vec<(f64, f64)>,
}

/// A computed cross-section.
pub struct Section<'a> {
    /// Its curves.
    pub curves: Vec<Curve>,
    count: &'a dyn Fn(f64, f64) -> usize,
    reach: f64,
    unit: &'static str,
}

/// Pixels of one line of the legend.
const LEGEND_LINE: f64 = 19.0;

/// Cells of the grid in each direction.
const CELLS: usize = 180;

/// What is carried by the first three joints: where axes 4 and 5 meet, or the tool point of an arm of three joints.
pub fn carried_point(body: &Body<f64>) -> Point {
    let (Some((p, a, _)), Some((q, b, _))) = (body.joints.get(3), body.joints.get(4)) else {
        return body.tip.origin;
    };
    // The point of axis 4 nearest to axis 5; they are not parallel in any wrist.
    let between = along(*q, -1.0, *p);
    let (ab, wa, wb) = (dot(*a, *b), dot(between, *a), dot(between, *b));
    along(*p, (wa - ab * wb) / (1.0 - ab * ab), *a)
}

/// The determinant of the position Jacobian of joints 1 to 3.
fn determinant(body: &Body<f64>) -> f64 {
    let point = carried_point(body);
    let column = |joint: usize| {
        let (at, axis, slides) = body.joints[joint];
        let arm = along(point, -1.0, at);
        if slides { axis } else { cross(axis, arm) }
    };
    dot(column(0), cross(column(1), column(2)))
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl<'a> Section<'a> {
    /// Follows the curves of an arm whose joints 1 to 3 turn. `count` says how many ways there are to bring the carried
    /// point to a distance from axis 1 and a height.
    pub fn of(model: &Model, unit: &'static str, count: &'a dyn Fn(f64, f64) -> usize) -> Section<'a> {
        let mut q = vec![0.0; model.arm.joints.len()];
        let mut at = |q2: f64, q3: f64| {
            (q[1], q[2]) = (q2, q3);
            model.body(&q)
        };
        let lines = zero_lines(&mut |q2, q3| determinant(&at(q2, q3)));
        let mut image = |(q2, q3): (f64, f64)| {
            let [x, y, z] = carried_point(&at(q2, q3));
            (x.hypot(y), z)
        };
        let mut section = Section { curves: Vec::new(), count, reach: model.reach(), unit };
        for line in lines {
            let points: Vec<_> = line.into_iter().map(&mut image).collect();
            section.add(&points);
        }
        section
    }

    /// Cuts a curve where it begins to separate something else.
    fn add(&mut self, points: &[(f64, f64)]) {
        let mut open: Option<Curve> = None;
        for pair in points.windows(2) {
            let edge = self.edge(pair[0], pair[1]);
            match &mut open {
                Some(curve) if edge.is_none_or(|edge| edge == curve.edge) => curve.points.push(pair[1]),
                _ => {
                    self.curves.extend(open.take());
                    let edge = edge.unwrap_or(Edge::Singular);
                    open = Some(Curve { edge, points: pair.to_vec() });
                }
            }
        }
        self.curves.extend(open);
    }

    /// What a piece separates; nothing if it is a point.
    fn edge(&self, a: (f64, f64), b: (f64, f64)) -> Option<Edge> {
        let (x, z) = (b.0 - a.0, b.1 - a.1);
        let length = x.hypot(z);
        if length < 1e-9 * self.reach {
            return None;
        }
        let (normal, middle) = ((-z / length, x / length), ((a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0));
        // The chord of a curved piece lies off it by less than a thousandth of its length.
        let step = 0.01 * length + 1e-6 * self.reach;
        let beside = |by: f64| ((middle.0 + by * normal.0).abs(), middle.1 + by * normal.1);
        let empty = [1.0, -1.0].into_iter().find(|sign| {
            let (rho, z) = beside(sign * step);
            (self.count)(rho, z) == 0
        });
        let Some(sign) = empty else { return Some(Edge::Singular) };
        // Beyond an outer boundary nothing is reached any more.
        let again = (1..=40).any(|k| {
            let (rho, z) = beside(sign * 0.05 * f64::from(k) * self.reach);
            (self.count)(rho, z) > 0
        });
        Some(if again { Edge::Inner } else { Edge::Outer })
    }

    /// The drawing: tints by the number of ways to reach a point, the curves, axes with units.
    pub fn draw(&self, width: f64, name: &str) -> Svg {
        let points = || self.curves.iter().flat_map(|c| &c.points);
        let right = 1.06 * points().map(|p| p.0).fold(0.0, f64::max);
        let (low, high) = points().map(|p| p.1).fold((f64::MAX, f64::MIN), |(l, h), z| (l.min(z), h.max(z)));
        let room = 0.04 * (high - low);
        let (low, high) = (low - room, high + room);
        let (left, top, legend) = (58.0, 12.0, 78.0);
        let scale = (width - left - 12.0) / right;
        let height = scale * (high - low) + top + 44.0 + legend;
        let place = |(rho, z): (f64, f64)| (left + scale * rho, top + scale * (high - z));
        let mut svg = Svg::new(width, height, name);
        self.tint(&mut svg, scale, (left, top), (right, low, high));
        let foot = top + scale * (high - low);
        let xs = Ticks::over([0.0, right].into_iter(), 4, false);
        let zs = Ticks::over([low, high].into_iter(), 7, false);
        for tick in xs.ticks() {
            let (x, _) = place((tick, low));
            svg.line((x, foot), (x, foot + 4.0), "axis");
            svg.text((x, foot + 17.0), Anchor::Middle, "soft small", &xs.shown(tick));
        }
        for tick in zs.ticks() {
            let (_, y) = place((0.0, tick));
            svg.line((left - 4.0, y), (left, y), "axis");
            svg.text((left - 7.0, y + 4.0), Anchor::End, "soft small", &zs.shown(tick));
        }
        svg.line((left, foot), (width - 12.0, foot), "axis");
        svg.line((left, top), (left, foot), "axis");
        svg.text(
            ((left + width) / 2.0, foot + 36.0),
            Anchor::Middle,
            "",
            &format!("distance from axis 1, {}", self.unit),
        );
        svg.text_upwards((13.0, (top + foot) / 2.0), "", &format!("height, {}", self.unit));
        let mut curves: Vec<&Curve> = self.curves.iter().collect();
        curves.sort_by_key(|c| std::cmp::Reverse(c.edge));
        for curve in curves {
            let points: Vec<_> = curve.points.iter().copied().map(place).collect();
            svg.polyline(&points, class(curve.edge));
        }
        self.legend(&mut svg, left, foot + 58.0);
        svg
    }

    fn legend(&self, svg: &mut Svg, left: f64, y: f64) {
        let (mut row, mut x) = (0.0, left);
        let names =
            [(Edge::Outer, "outer boundary"), (Edge::Inner, "inner boundary"), (Edge::Singular, "singular")];
        for (edge, text) in names {
            if self.curves.iter().any(|c| c.edge == edge) {
                let wide = 34.0 + 6.6 * text.len() as f64;
                if x + wide > svg.width() {
                    (row, x) = (row + 1.0, left);
                }
                let y = y + LEGEND_LINE * row;
                svg.line((x, y - 4.0), (x + 20.0, y - 4.0), class(edge));
                svg.text((x + 25.0, y), Anchor::Start, "small", text);
                x += wide;
            }
        }
        let y = y + LEGEND_LINE * (row + 1.0);
        svg.text((left, y), Anchor::Start, "small", "ways to reach a point:");
        for (index, text) in ["1–2", "3–4", "more"].into_iter().enumerate() {
            let x = left + 135.0 + 52.0 * index as f64;
            svg.rectangle((x, y - 10.0), (12.0, 12.0), &format!("t{}", index + 1));
            svg.text((x + 17.0, y), Anchor::Start, "small", text);
        }
    }

    /// Rows two pixels high, cut where the number of solutions changes.
    fn tint(&self, svg: &mut Svg, scale: f64, (left, top): (f64, f64), (right, low, high): (f64, f64, f64)) {
        let level = |count: usize| count.min(5).div_ceil(2);
        let step = 2.0 / scale;
        for row in 0..((high - low) / step) as usize {
            let z = high - (row as f64 + 0.5) * step;
            let at = |rho: f64| level((self.count)(rho, z));
            let (mut start, mut current, mut last) = (0.0, at(0.25 * step), 0.25 * step);
            let mut put = |from: f64, to: f64, level: usize| {
                if level > 0 {
                    let corner = (left + scale * from, top + 2.0 * row as f64);
                    svg.rectangle(corner, (scale * (to - from), 2.3), &format!("t{level}"));
                }
            };
            while last < right {
                let next = last + 2.0 * step;
                let found = at(next);
                if found != current {
                    let (mut a, mut b) = (last, next);
                    for _ in 0..12 {
                        let middle = (a + b) / 2.0;
                        if at(middle) == current { a = middle } else { b = middle }
                    }
                    put(start, b, current);
                    (start, current) = (b, found);
                }
                last = next;
            }
            put(start, right.max(start), current);
        }
    }
}

fn class(edge: Edge) -> &'static str {
    match edge {
        Edge::Outer => "outer",
        Edge::Inner => "inner",
        Edge::Singular => "singular",
    }
}

/// An edge of the grid: the cell to its right or above it, and whether it is upright.
type Side = (usize, usize, bool);

/// Where a function of two angles vanishes: rows of points, each on a line of the grid.
fn zero_lines(f: &mut dyn FnMut(f64, f64) -> f64) -> Vec<Vec<(f64, f64)>> {
    // Not symmetric about zero, so that no curve runs along a line of the grid.
    let angle = |k: usize| -PI + 2.0 * PI * (k as f64 + 0.381_966) / CELLS as f64;
    let values: Vec<Vec<f64>> =
        (0..=CELLS).map(|i| (0..=CELLS).map(|j| f(angle(i), angle(j))).collect()).collect();
    let mut crossing = |(i, j, upright): Side| {
        let (di, dj) = if upright { (0, 1) } else { (1, 0) };
        let (from, to) = (values[i][j], values[i + di][j + dj]);
        if (from < 0.0) == (to < 0.0) {
            return None;
        }
        let (mut a, mut b) = ((angle(i), angle(j)), (angle(i + di), angle(j + dj)));
        for _ in 0..52 {
            let middle = ((a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0);
            if (f(middle.0, middle.1) < 0.0) == (from < 0.0) { a = middle } else { b = middle }
        }
        Some(a)
    };
    let mut points: BTreeMap<Side, (f64, f64)> = BTreeMap::new();
    let mut links: BTreeMap<Side, Vec<Side>> = BTreeMap::new();
    for i in 0..=CELLS {
        for j in 0..=CELLS {
            for side in [(i, j, false), (i, j, true)] {
                let inside = if side.2 { j < CELLS } else { i < CELLS };
                if inside && let Some(point) = crossing(side) {
                    points.insert(side, point);
                }
            }
        }
    }
    for i in 0..CELLS {
        for j in 0..CELLS {
            let sides = [(i, j, true), (i, j, false), (i + 1, j, true), (i, j + 1, false)];
            let crossed: Vec<Side> = sides.into_iter().filter(|s| points.contains_key(s)).collect();
            // Four crossings: two curves cross in the cell; each goes straight on.
            let pairs = match crossed.as_slice() {
                [a, b] => vec![(*a, *b)],
                [a, b, c, d] => vec![(*a, *c), (*b, *d)],
                _ => Vec::new(),
            };
            for (a, b) in pairs {
                links.entry(a).or_default().push(b);
                links.entry(b).or_default().push(a);
            }
        }
    }
    chained(&points, links)
}

/// Rows of linked points, as long as they go.
fn chained(
    points: &BTreeMap<Side, (f64, f64)>,
    mut links: BTreeMap<Side, Vec<Side>>,
) -> Vec<Vec<(f64, f64)>> {
    let mut lines = Vec::new();
    // Ends first, so that open curves are not begun in their middle.
    let mut starts: Vec<Side> = links.iter().filter(|(_, l)| l.len() == 1).map(|(s, _)| *s).collect();
    starts.extend(links.keys().copied());
    for start in starts {
        let mut line = Vec::new();
        let mut at = start;
        while let Some(next) = links.get_mut(&at).and_then(Vec::pop) {
            if line.is_empty() {
                line.extend(points.get(&at));
            }
            if let Some(back) = links.get_mut(&next) {
                back.retain(|other| *other != at);
            }
            line.extend(points.get(&next));
            at = next;
        }
        if line.len() > 1 {
            lines.push(line);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use kin_runtime::prelude::*;
    use robots::LabRrr;

    #[test]
    fn the_boundary_of_the_three_joint_arm_is_two_circles() {
        let model = Model::of(LabRrr::TABLE).unwrap_or_else(|e| panic!("{e}"));
        let count = |rho: f64, z: f64| LabRrr.ik_position(&Point3::new(rho, 0.0, z)).len();
        let section = Section::of(&model, "m", &count);
        let outer: Vec<_> = section.curves.iter().filter(|c| c.edge == Edge::Outer).collect();
        assert!(!outer.is_empty());
        for (rho, z) in outer.iter().flat_map(|c| &c.points) {
            // Stretched: both links in one line from the shoulder, which stands 0.168 m high on axis 1.
            assert!(((z - 0.168).hypot(*rho) - 2.0 * 0.13335).abs() < 1e-13, "{rho} {z}");
        }
        // From pole to pole: the half circle is there as a whole.
        let heights = outer.iter().flat_map(|c| &c.points).map(|p| p.1 - 0.168);
        let (low, high) = heights.fold((0.0f64, 0.0f64), |(l, h), z| (l.min(z), h.max(z)));
        assert!(low < -0.2665 && high > 0.2665, "{low} {high}");
        // The links are equally long: folded, the arm reaches its own shoulder, and there is no void.
        assert!(section.curves.iter().all(|c| c.edge != Edge::Inner));
        for curve in section.curves.iter().filter(|c| c.edge == Edge::Singular) {
            assert!(curve.points.iter().all(|(rho, _)| *rho < 1e-9), "axis 1 itself");
        }
    }
}
