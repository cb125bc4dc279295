//! From where an arm is looked at: parallel projection, so that equal lengths look equal.

/// A point in the base frame.
pub type Point = [f64; 3];

/// A direction of sight.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct View {
    right: Point,
    up: Point,
    towards: Point,
}

impl View {
    /// From the side: x to the right, z up; the viewer stands at negative y.
    pub const SIDE: View = View { right: [1.0, 0.0, 0.0], up: [0.0, 0.0, 1.0], towards: [0.0, -1.0, 0.0] };
    /// From the front: y to the right, z up; the viewer stands at positive x.
    pub const FRONT: View = View { right: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], towards: [1.0, 0.0, 0.0] };
    /// From above: x to the right, y up.
    pub const TOP: View = View { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], towards: [0.0, 0.0, 1.0] };

    /// The viewer stands at that azimuth, counted from x towards y, and at that elevation above the ground; z points up.
    /// Degrees.
    pub fn from(azimuth: f64, elevation: f64) -> View {
        let ((sa, ca), (se, ce)) = (azimuth.to_radians().sin_cos(), elevation.to_radians().sin_cos());
        View { right: [-sa, ca, 0.0], up: [-se * ca, -se * sa, ce], towards: [ce * ca, ce * sa, se] }
    }

    /// To the right, upwards, and towards the viewer.
    pub fn seen(&self, p: Point) -> Point {
        [dot(self.right, p), dot(self.up, p), dot(self.towards, p)]
    }
}

/// The scalar product.
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a + factor·b`.
pub fn along(a: Point, factor: f64, b: Point) -> Point {
    [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_are_right_handed_and_keep_lengths() {
        for view in [View::SIDE, View::FRONT, View::TOP, View::from(-60.0, 20.0), View::from(200.0, -70.0)] {
            let [r, u, t] = [view.right, view.up, view.towards];
            for (a, b) in [(r, u), (u, t), (t, r)] {
                assert!(dot(a, b).abs() < 1e-15 && (dot(a, a) - 1.0).abs() < 1e-15, "{view:?}");
            }
            let cross = [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]];
            assert!((dot(cross, t) - 1.0).abs() < 1e-15, "{view:?}");
            let p = [0.3, -0.7, 2.0];
            assert!((dot(view.seen(p), view.seen(p)) - dot(p, p)).abs() < 1e-14);
        }
        // From azimuth -90° and no elevation one sees what one sees from the side.
        let side = View::from(-90.0, 0.0);
        assert!((0..3).all(|i| (side.right[i] - View::SIDE.right[i]).abs() < 1e-15));
    }
}
