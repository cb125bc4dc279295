//! The constants that the shared solver is told: bases, wrists, and the quantities they are made of.

use std::fmt::Write;

use super::{Printer, line};
use crate::back::infix::{self, Leaves};
use crate::family::base::{Base, Figure, Shape, Stand};
use crate::family::general::Axis;
use crate::family::pair::Pair;
use crate::family::short::{Carrier, Turns};
use crate::family::wrist::{Wrist, WristForm};
use crate::number::Real;
use crate::program::Program;
use crate::quantity::{Linear, Quantity};

impl Printer<'_> {
    /// The method that hands the base over.
    pub(super) fn base(&self, text: &mut String, base: &Base) {
        let krate = self.krate;
        line!(text, "/// The base's geometry, measured in the shoulder frame.");
        line!(text, "fn base<T: {krate}::Float>(&self) -> {krate}::Base<T> {{");
        self.base_value(text, base);
        line!(text, "}}");
    }

    fn base_value(&self, text: &mut String, base: &Base) {
        let krate = self.krate;
        let kind = match &base.shape {
            Shape::General(_) => "General",
            Shape::Stand(stand) => match &stand.figure {
                Figure::Elbow { .. } => "Elbow",
                Figure::Telescope { .. } => "Telescope",
            },
        };
        line!(text, "{krate}::Base::{kind}({krate}::{kind}Base {{");
        match &base.shape {
            Shape::Stand(stand) => self.stand(text, stand),
            Shape::General(general) => self.lines(text, &general.axes, &general.carried),
        }
        line!(text, "offset: [{}],", self.offsets(&base.offsets));
        if let Shape::Stand(stand) = &base.shape {
            line!(text, "reversed: {:?},", stand.reversed);
        }
        line!(text, "reach: {},\n}})", self.reach_in_t());
    }

    /// The method that hands two joints over.
    pub(super) fn pair(&self, text: &mut String, pair: &Pair) {
        let krate = self.krate;
        line!(text, "/// The geometry of the two joints, measured in the first row's frame.");
        line!(text, "fn base<T: {krate}::Float>(&self) -> {krate}::PairBase<T> {{");
        self.pair_value(text, pair);
        line!(text, "}}");
    }

    fn pair_value(&self, text: &mut String, pair: &Pair) {
        line!(text, "{}::PairBase {{", self.krate);
        self.lines(text, &pair.lines, &pair.carried);
        line!(text, "offset: [{}],", self.offsets(&pair.offsets));
        line!(text, "reach: {},\n}}", self.reach_in_t());
    }

    /// The method that hands over the joints that carry a point.
    pub(super) fn carrier(&self, text: &mut String, carrier: &Carrier) {
        let krate = self.krate;
        line!(text, "/// The geometry of the joints that carry the point.");
        line!(text, "fn carrier<T: {krate}::Float>(&self) -> {krate}::Carrier<T> {{");
        match carrier {
            Carrier::Three(base) => {
                line!(text, "{krate}::Carrier::Three(");
                self.base_value(text, base);
            }
            Carrier::Two(pair) => {
                line!(text, "{krate}::Carrier::Two(");
                self.pair_value(text, pair);
            }
        }
        line!(text, ")\n}}");
    }

    /// The method that hands over the joints that turn the tool about the point.
    pub(super) fn turns_of(&self, text: &mut String, turns: &Turns) {
        let krate = self.krate;
        line!(text, "/// The joints that turn the tool about the point.");
        line!(text, "fn turns<T: {krate}::Float>(&self) -> {krate}::Turns<T> {{");
        let offsets = self.offsets(&turns.offsets);
        match (&turns.between, turns.offsets.as_slice()) {
            (Some(between), _) => {
                let between = self.numbers(between);
                line!(text, "{krate}::Turns::Two {{ between: {between}, offset: [{offsets}] }}");
            }
            (None, []) => line!(text, "{krate}::Turns::None"),
            (None, _) => line!(text, "{krate}::Turns::One {{ offset: {offsets} }}"),
        }
        line!(text, "}}");
    }

    pub(super) fn offsets(&self, offsets: &[Quantity]) -> String {
        offsets.iter().map(|o| self.quantity(o)).collect::<Vec<_>>().join(", ")
    }

    fn reach_in_t(&self) -> String {
        match self.arm.reach.as_f64() {
            Some(value) => self.literal(value),
            None => format!("T::lit({}::Arm::reach(self))", self.krate),
        }
    }

    fn stand(&self, text: &mut String, stand: &Stand) {
        let field = |value: &Linear| self.linear_in_t(value);
        line!(text, "a1: {},", field(&stand.shoulder));
        let (sin, cos) = (self.literal(stand.twist.0.to_f64()), self.literal(stand.twist.1.to_f64()));
        line!(text, "twist: ({sin}, {cos}),");
        line!(text, "lateral: {},", field(&stand.lateral));
        match &stand.figure {
            Figure::Elbow { upper, fore } => {
                line!(text, "upper: {},", self.quantity(upper));
                line!(text, "fore: {},", self.quantity(fore));
            }
            Figure::Telescope { arm } => line!(text, "arm: {},", field(arm)),
        }
    }

    fn lines(&self, text: &mut String, axes: &[Axis], carried: &[Linear; 3]) {
        let krate = self.krate;
        let point = |v: &[Linear; 3]| v.each_ref().map(|l| self.linear_in_t(l)).join(", ");
        line!(text, "axes: [");
        for axis in axes {
            let direction = axis.direction.map(|d| self.literal(d.to_f64())).join(", ");
            line!(text, "{krate}::Axis {{ slides: {}, direction: [{direction}],", axis.slides);
            line!(text, "point: [{}] }},", point(&axis.point));
        }
        line!(text, "],\ncarried: [{}],", point(carried));
    }

    /// The call that reads a wrist's angles from the outputs of a program.
    pub(super) fn wrist_value(&self, wrist: &Wrist, program: &Program) -> String {
        let krate = self.krate;
        let m = self.rows(program);
        let offsets = self.offsets(&wrist.offsets);
        match &wrist.form {
            WristForm::Orthogonal => format!("{krate}::private::zyz({m}, [{offsets}], [false; 3])"),
            WristForm::Oblique(between) => {
                let [k4, k5] = [&between[0], &between[1]].map(|k| self.numbers(k));
                format!("{krate}::private::oblique({m}, {k4}, {k5}, [{offsets}], [false; 3])")
            }
        }
    }

    fn numbers(&self, m: &[[Real; 3]; 3]) -> String {
        let row = |r: &[Real; 3]| format!("[{}]", r.map(|v| self.literal(v.to_f64())).join(", "));
        format!("[{}]", m.iter().map(row).collect::<Vec<_>>().join(", "))
    }

    /// The body of `Arm::reach`.
    pub(super) fn reach(&self) -> String {
        let krate = self.krate;
        match &self.arm.reach {
            Quantity::SumOfAbsolutes(constant, forms) => {
                let mut text = format!("{:?}", constant.to_f64());
                for form in forms {
                    let linear = self.linear(form, &|v| format!("{v:?}"), &|name| format!("self.{name}"));
                    let _ = write!(text, " + {krate}::private::abs({linear})");
                }
                text
            }
            other => self.quantity(other),
        }
    }

    fn quantity(&self, quantity: &Quantity) -> String {
        let krate = self.krate;
        match quantity {
            Quantity::Linear(linear) => self.linear_in_t(linear),
            Quantity::Length(x, y) => {
                format!("{krate}::private::hypot({}, {})", self.linear_in_t(x), self.linear_in_t(y))
            }
            Quantity::Angle(rest, directions) => {
                let mut text = String::new();
                for (negative, x, y) in directions {
                    let (x, y) = (self.linear_in_t(x), self.linear_in_t(y));
                    infix::append(&mut text, *negative, &format!("{krate}::private::atan2({y}, {x})"));
                }
                if !(rest.params.is_empty() && rest.constant.is_zero()) {
                    infix::append(&mut text, false, &format!("({})", self.linear_in_t(rest)));
                }
                text
            }
            Quantity::SumOfAbsolutes(..) => "T::lit(0.0)".to_owned(),
        }
    }

    fn linear_in_t(&self, linear: &Linear) -> String {
        self.linear(linear, &|v| self.literal(v), &|name| format!("T::lit(self.{name})"))
    }

    fn linear(
        &self,
        linear: &Linear,
        literal: &dyn Fn(f64) -> String,
        param: &dyn Fn(&str) -> String,
    ) -> String {
        let mut text = String::new();
        for (coefficient, index) in &linear.params {
            let Some(facts) = self.arm.params.get(*index) else { continue };
            let value = coefficient.to_f64();
            let name = param(&facts.name);
            let factor = if value.abs() == 1.0 { name } else { format!("{} * {name}", literal(value.abs())) };
            infix::append(&mut text, value < 0.0, &factor);
        }
        let constant = linear.constant.to_f64();
        if text.is_empty() {
            return literal(constant);
        }
        if constant != 0.0 {
            infix::append(&mut text, constant < 0.0, &literal(constant.abs()));
        }
        text
    }
}
