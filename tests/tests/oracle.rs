//! The oracles themselves against the 50-digit data.

use tests::pose::difference;
use tests::{product, reference};

#[test]
fn the_plain_product_agrees_with_fifty_digits() {
    for arm in reference::arms() {
        let mut worst = (0.0_f64, 0.0_f64);
        for case in arm.cases().fk {
            let off = difference(&product::pose(&arm, &case.q), &case.pose).relative(arm.reach());
            let columns = product::jacobian(&arm, &case.q);
            let entries = (0..6)
                .flat_map(|i| columns.iter().zip(&case.jacobian[i]).map(move |(c, j)| (c[i] - j).abs()));
            worst = (worst.0.max(off), entries.fold(worst.1, f64::max));
        }
        assert!(worst.0 < 5e-15 && worst.1 < 1e-14 * arm.reach().max(1.0), "{}: {worst:?}", arm.name);
    }
}
