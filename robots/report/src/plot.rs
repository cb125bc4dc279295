//! Plots against time, or against anything: axes with units, several series, marks and thresholds.

use crate::svg::{Anchor, Svg};

/// A quantity along an axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it is and, after a comma, its unit.
    pub label: String,
}

/// A row of points with a name.
#[derive(Clone, Debug)]
pub struct Series {
    /// As the legend has it.
    pub name: String,
    /// The points, by their first coordinate.
    pub points: Vec<(f64, f64)>,
    /// Whether the value is held from one point to the next.
    pub stepped: bool,
}

impl Series {
    /// Points joined by lines.
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { name: name.into(), points, stepped: false }
    }

    /// Values held until the next point.
    #[must_use]
    pub fn stepped(self) -> Series {
        Series { stepped: true, ..self }
    }
}

/// A plot being composed.
#[derive(Clone, Debug)]
pub struct Plot {
    across: Axis,
    upwards: Axis,
    series: Vec<Series>,
    marks: Vec<(f64, String)>,
    levels: Vec<(f64, String)>,
}

/// Pixels left of, above, right of and below the field.
const FIELD: [f64; 4] = [62.0, 10.0, 14.0, 42.0];
/// Pixels of one line of the legend.
const LINE: f64 = 17.0;

impl Plot {
    /// Axes without anything; each label ends with its unit.
    pub fn new(across: &str, upwards: &str) -> Plot {
        let axis = |label: &str| Axis { label: label.to_owned() };
        Plot {
            across: axis(across),
            upwards: axis(upwards),
            series: Vec::new(),
            marks: Vec::new(),
            levels: Vec::new(),
        }
    }

    /// One series more.
    #[must_use]
    pub fn series(mut self, series: Series) -> Plot {
        self.series.push(series);
        self
    }

    /// A vertical line with words.
    #[must_use]
    pub fn mark(mut self, at: f64, text: impl Into<String>) -> Plot {
        self.marks.push((at, text.into()));
        self
    }

    /// A horizontal line with words.
    #[must_use]
    pub fn level(mut self, at: f64, text: impl Into<String>) -> Plot {
        self.levels.push((at, text.into()));
        self
    }

    /// The drawing; `key` is unique on its page.
    pub fn draw(&self, width: f64, height: f64, key: &str, name: &str) -> Svg {
        let legend = self.legend(width);
        let rows = legend.iter().map(|(row, ..)| row + 1).max().unwrap_or(0);
        let top = FIELD[1] + LINE * rows as f64;
        let (w, h) = (width - FIELD[0] - FIELD[2], height - top - FIELD[3]);
        let points = || self.series.iter().flat_map(|s| &s.points);
        let xs = Ticks::over(points().map(|p| p.0), (w / 60.0) as usize, false);
        let levels = self.levels.iter().map(|(at, _)| *at);
        let ys = Ticks::over(points().map(|p| p.1).chain(levels), (h / 34.0) as usize, true);
        let place = |(x, y): (f64, f64)| (FIELD[0] + w * xs.part(x), top + h * (1.0 - ys.part(y)));
        let mut svg = Svg::new(width, height, name);
        self.draw_legend(&mut svg, &legend);
        for tick in xs.ticks() {
            let (x, _) = place((tick, ys.low));
            svg.line((x, top), (x, top + h), "grid");
            svg.text((x, top + h + 16.0), Anchor::Middle, "soft small", &xs.shown(tick));
        }
        for tick in ys.ticks() {
            let (_, y) = place((xs.low, tick));
            svg.line((FIELD[0], y), (FIELD[0] + w, y), "grid");
            svg.text((FIELD[0] - 6.0, y + 4.0), Anchor::End, "soft small", &ys.shown(tick));
        }
        svg.line((FIELD[0], top + h), (FIELD[0] + w, top + h), "axis");
        svg.line((FIELD[0], top), (FIELD[0], top + h), "axis");
        svg.text((FIELD[0] + w / 2.0, height - 6.0), Anchor::Middle, "", &self.across.label);
        svg.text_upwards((13.0, top + h / 2.0), "", &self.upwards.label);
        svg.clip(key, (FIELD[0], top - 2.0), (w + 1.0, h + 4.0));
        for (index, series) in self.series.iter().enumerate() {
            let class = format!("series s{0} d{0}", index % 6 + 1);
            let points: Vec<_> = series.course().into_iter().map(place).collect();
            svg.polyline(&points, &class);
        }
        svg.close();
        for (at, text) in &self.levels {
            let (_, y) = place((xs.low, *at));
            svg.line((FIELD[0], y), (FIELD[0] + w, y), "mark");
            svg.text((FIELD[0] + w - 4.0, y - 5.0), Anchor::End, "halo small warn", text);
        }
        for (at, text) in &self.marks {
            let (x, _) = place((*at, ys.low));
            svg.line((x, top), (x, top + h), "mark");
            let left = x > FIELD[0] + 0.6 * w;
            let (x, anchor) = if left { (x - 5.0, Anchor::End) } else { (x + 5.0, Anchor::Start) };
            svg.text((x, top + 14.0), anchor, "halo small warn", text);
        }
        svg
    }

    /// Row, column in pixels, and series of each entry; nothing for a single series.
    fn legend(&self, width: f64) -> Vec<(usize, f64, usize)> {
        if self.series.len() < 2 {
            return Vec::new();
        }
        let (mut row, mut x) = (0, FIELD[0]);
        let mut places = Vec::new();
        for (index, series) in self.series.iter().enumerate() {
            let wide = 40.0 + 7.2 * series.name.chars().count() as f64;
            if x + wide > width - FIELD[2] && x > FIELD[0] {
                (row, x) = (row + 1, FIELD[0]);
            }
            places.push((row, x, index));
            x += wide;
        }
        places
    }

    fn draw_legend(&self, svg: &mut Svg, places: &[(usize, f64, usize)]) {
        for &(row, x, index) in places {
            let y = 12.0 + LINE * row as f64;
            let class = format!("series s{0} d{0}", index % 6 + 1);
            svg.line((x, y - 4.0), (x + 22.0, y - 4.0), &class);
            svg.text((x + 27.0, y), Anchor::Start, "small", &self.series[index].name);
        }
    }
}

impl Series {
    fn course(&self) -> Vec<(f64, f64)> {
        if !self.stepped {
            return self.points.clone();
        }
        let held = self.points.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
        held.chain(self.points.last().copied()).collect()
    }
}

/// The ticks of an axis: multiples of one, two or five times a power of ten.
pub(crate) struct Ticks {
    low: f64,
    high: f64,
    step: f64,
}

impl Ticks {
    /// About `count` ticks over these values; `whole` ends the axis at ticks.
    pub(crate) fn over(values: impl Iterator<Item = f64>, count: usize, whole: bool) -> Ticks {
        let finite = values.filter(|v| v.is_finite());
        let (mut low, mut high) =
            finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        if high - low < 1e-12 * (1.0 + high.abs()) {
            (low, high) = (low - 0.5 * low.abs().max(1e-3), high + 0.5 * high.abs().max(1e-3));
        }
        let wanted = (high - low) / count.clamp(2, 10) as f64;
        let power = 10f64.powf(wanted.log10().floor());
        let step = [1.0, 2.0, 5.0]
            .into_iter()
            .map(|k| k * power)
            .find(|s| *s >= wanted * 0.999)
            .unwrap_or(10.0 * power);
        if whole {
            (low, high) = ((low / step + 1e-9).floor() * step, (high / step - 1e-9).ceil() * step);
        }
        Ticks { low, high, step }
    }

    fn part(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    pub(crate) fn ticks(&self) -> Vec<f64> {
        let first = (self.low / self.step - 1e-9).ceil() as i64;
        let last = (self.high / self.step + 1e-9).floor() as i64;
        (first..=last).map(|k| k as f64 * self.step).collect()
    }

    /// With the digits that tell one tick from the next.
    pub(crate) fn shown(&self, tick: f64) -> String {
        let digits = (-self.step.log10().floor()).max(0.0) as usize;
        if digits > 4 || tick.abs() >= 1e6 {
            return if tick == 0.0 { "0".to_owned() } else { format!("{tick:.1e}") };
        }
        let text = format!("{tick:.digits$}");
        if text.trim_start_matches(['-', '0', '.']).is_empty() {
            "0".to_owned()
        } else {
            text.replace('-', "−")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_cover_the_values() {
        for (low, high) in [(0.0, 1.7), (-3.2, 3.1), (1e-7, 3e-7), (100.0, 100.0), (-5.0, 2000.0)] {
            let ticks = Ticks::over([low, high].into_iter(), 6, true);
            let room = 1e-8 * ticks.step;
            assert!(ticks.low <= low + room && ticks.high >= high - room, "{low} {high}");
            // No empty step at either end.
            assert!(
                ticks.low > low - ticks.step && ticks.high < high + ticks.step || low == high,
                "{low} {high}"
            );
            let all = ticks.ticks();
            assert!((2..=12).contains(&all.len()), "{low} {high}: {all:?}");
            let shown: std::collections::BTreeSet<String> = all.iter().map(|t| ticks.shown(*t)).collect();
            assert_eq!(shown.len(), all.len(), "{shown:?}");
        }
    }

    #[test]
    fn held_values_step() {
        let held = Series::new("n", vec![(0.0, 8.0), (1.0, 4.0)]).stepped();
        assert_eq!(held.course(), [(0.0, 8.0), (1.0, 8.0), (1.0, 4.0)]);
    }
}
