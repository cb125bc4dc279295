//! Task 6: the check for singularities along the trajectory.

use kin_runtime::trajectory::Trajectory;
use kin_runtime::watch::{Factor, Measure, Reading, Watch};
use robots::ElbowWrist;

use super::motion::RATE;
use crate::html::{Page, Table, number, rough};
use crate::plot::{Plot, Series};

/// The margin below which a warning is due.
const THRESHOLD: f64 = 0.02;

pub(super) fn task(page: &mut Page, trajectory: &Trajectory<f64, 6>) {
    page.part("Task 6: singularities along the trajectory");
    let watch = Watch::new(&ElbowWrist, trajectory);
    let Ok(readings) = watch.readings(RATE) else { return };
    let readings: Vec<_> = readings.collect();
    let determinants: Vec<(f64, f64)> =
        readings.iter().map(|r| (r.state.time, r.determinant.unwrap_or(0.0))).collect();
    let least = determinants.iter().map(|(_, d)| d.abs()).fold(f64::INFINITY, f64::min);
    let crossings: Vec<f64> = watch.factor_crossings(Factor::Wrist, 0.0).map(|c| c.time).collect();
    page.text(&format!(
        "The report looks for a determinant of zero at the samples. There the smallest |det J| is {}, linear rows divided by \
         the arm’s lengths, and a test for zero sees nothing. The monitor finds every crossing between the samples too: the \
         wrist is stretched {}.",
        rough(least),
        match crossings.as_slice() {
            [] => "nowhere".to_owned(),
            times => times.iter().map(|t| format!("at t = {} s", number(*t, 9))).collect::<Vec<_>>().join(" and "),
        }
    ));
    let mut table = Table::new(&["t, s", "det J, sample before", "det J, sample after"]);
    for time in &crossings {
        let before = determinants.iter().rev().find(|(t, _)| t <= time).map_or(0.0, |(_, d)| *d);
        let after = determinants.iter().find(|(t, _)| t > time).map_or(0.0, |(_, d)| *d);
        table.row("crossing", vec![number(*time, 9), rough(before), rough(after)]);
    }
    page.table(&table);
    let words: Vec<String> =
        watch.spells(Measure::Margin, THRESHOLD).map(|spell| spell.to_string()).collect();
    if !words.is_empty() {
        page.text(&format!("Its warnings for a smallest singular value below {THRESHOLD}:"));
        for sentence in words {
            page.warning(&sentence);
        }
    }
    plots(page, &watch, &readings, &crossings);
}

/// det J and what it is made of, over time.
fn plots(
    page: &mut Page,
    watch: &Watch<'_, ElbowWrist, f64, 6>,
    readings: &[Reading<f64, 6>],
    crossings: &[f64],
) {
    let over = |value: &dyn Fn(&Reading<f64, 6>) -> f64| -> Vec<(f64, f64)> {
        readings.iter().map(|r| (r.state.time, value(r))).collect()
    };
    let marked = |mut plot: Plot| {
        for time in crossings {
            plot = plot.mark(*time, "wrist singular");
        }
        plot
    };
    let factors = |factor: Factor| over(&|r| watch.factors(r.state.time).get(factor).unwrap_or(0.0));
    let plots = [
        (
            marked(
                Plot::new("time, s", "det J, normalised")
                    .series(Series::new("det J", over(&|r| r.determinant.unwrap_or(0.0)))),
            ),
            "clip-det",
            "det J over time",
        ),
        (
            marked(
                Plot::new("time, s", "manipulability")
                    .series(Series::new("manipulability", over(&|r| r.dexterity.manipulability))),
            ),
            "clip-w",
            "Manipulability over time",
        ),
        (
            marked(
                Plot::new("time, s", "smallest singular value")
                    .series(Series::new("margin", over(&|r| r.dexterity.margin)))
                    .level(THRESHOLD, "threshold"),
            ),
            "clip-margin",
            "Smallest singular value over time",
        ),
        (
            marked(
                Plot::new("time, s", "factors of det J, normalised")
                    .series(Series::new("shoulder", factors(Factor::Shoulder)))
                    .series(Series::new("elbow", factors(Factor::Elbow)))
                    .series(Series::new("wrist", factors(Factor::Wrist))),
            ),
            "clip-factors",
            "Factors of det J over time",
        ),
    ];
    let drawings: Vec<_> =
        plots.iter().map(|(plot, key, name)| (plot.draw(480.0, 290.0, key, name), String::new())).collect();
    page.figure(
        "figure-singular",
        &drawings,
        "The singularity check: linear rows divided by the sum of all lengths, so that the figures have no unit.",
    );
}
