//! On which side of a threshold a figure of a Jacobian is, computed in no way that the library knows.
//!
//! Determinants by cofactors; the product of the singular values of a matrix with more columns than rows by all of its minors
//! (A.-L. Cauchy and J. Binet 1812); whether the smallest singular value is above a threshold by whether J·Jᵀ - c²·1 has a Cholesky
//! factor (A.-L. Cholesky 1910).

/// What is watched.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Figure {
    /// det J.
    Determinant,
    /// The smallest singular value.
    Margin,
    /// The product of the singular values.
    Manipulability,
    /// The volume that the last three of six axes span.
    Wrist,
}

impl Figure {
    /// Whether it is above a threshold; `columns` are those of a Jacobian with that many rows that count, 3 or 6.
    pub fn above(self, columns: &[[f64; 6]], rows: usize, threshold: f64) -> bool {
        match self {
            Figure::Determinant => determinant(columns) > threshold,
            Figure::Margin => all_above(columns, rows, threshold),
            Figure::Manipulability => squared(columns, rows) > threshold * threshold,
            Figure::Wrist => triple([3, 4, 5].map(|i| half(&columns[i], 3))) > threshold,
        }
    }
}

/// Three entries of a column, from one on.
fn half(column: &[f64; 6], from: usize) -> [f64; 3] {
    [column[from], column[from + 1], column[from + 2]]
}

fn triple([[a, b, c], [d, e, f], [g, h, i]]: [[f64; 3]; 3]) -> f64 {
    a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
}

/// All ways of choosing three of so many.
fn threes(many: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..many).flat_map(move |i| (i + 1..many).flat_map(move |j| (j + 1..many).map(move |k| [i, j, k])))
}

/// Laplace's expansion by the linear rows of six columns.
fn determinant(columns: &[[f64; 6]]) -> f64 {
    threes(6)
        .map(|chosen| {
            let mut rest = [0; 3];
            for (place, left) in rest.iter_mut().zip((0..6).filter(|m| !chosen.contains(m))) {
                *place = left;
            }
            let sign = if chosen.iter().sum::<usize>() % 2 == 1 { 1.0 } else { -1.0 };
            sign * triple(chosen.map(|m| half(&columns[m], 0))) * triple(rest.map(|m| half(&columns[m], 3)))
        })
        .sum()
}

/// The square of the product of the singular values: the sum of the squares of all largest minors.
fn squared(columns: &[[f64; 6]], rows: usize) -> f64 {
    if rows == 3 {
        return threes(columns.len()).map(|c| triple(c.map(|m| half(&columns[m], 0))).powi(2)).sum();
    }
    if columns.len() == 6 {
        return determinant(columns).powi(2);
    }
    let without = |left: usize| {
        let mut six = columns.to_vec();
        six.remove(left);
        six
    };
    (0..columns.len()).map(|left| squared(&without(left), rows)).sum()
}

/// Whether J·Jᵀ - c²·1 is positive definite: whether every singular value is above c.
fn all_above(columns: &[[f64; 6]], rows: usize, c: f64) -> bool {
    let mut m = [[0.0; 6]; 6];
    for i in 0..rows {
        for j in 0..=i {
            m[i][j] = columns.iter().map(|column| column[i] * column[j]).sum();
        }
        m[i][i] -= c * c;
    }
    for i in 0..rows {
        for j in 0..=i {
            let rest = m[i][j] - (0..j).map(|k| m[i][k] * m[j][k]).sum::<f64>();
            if i == j {
                if rest <= 0.0 {
                    return false;
                }
                m[i][i] = rest.sqrt();
            } else {
                m[i][j] = rest / m[j][j];
            }
        }
    }
    true
}
