//! The names of a declaration and what they stand for.

use super::value::{Constant, Value};
use super::{Param, ParamKind};
use crate::decl::nearest::nearest;
use crate::decl::{AngleUnit, Binding, Decl, LengthUnit, Unit, is_joint_variable};
use crate::number::{Ratio, Scalar};
use crate::report::{Place, Report};

/// Words that cannot name a field or a variable of the generated code.
const RUST: [&str; 52] = [
    "_", "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let",
    "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self",
    "static", "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use",
    "virtual", "where", "while",
];

/// What a name stands for.
#[derive(Clone, Debug)]
pub(super) enum Meaning {
    /// A constant; `None` after a mistake that was reported.
    Let(Option<Value>),
    /// The parameter of that index.
    Param(usize),
}

/// A bound name.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub(super) text: String,
    pub(super) place: Place,
    pub(super) meaning: Meaning,
    pub(super) used: bool,
}

/// A parameter whose kind its uses have yet to decide.
#[derive(Clone, Debug)]
pub(super) struct OpenParam {
    pub(super) name: String,
    pub(super) place: Place,
    /// `None` after a mistake that was reported.
    pub(super) nominal: Option<Value>,
    pub(super) kind: Option<ParamKind>,
}

/// Everything an expression may refer to.
pub(super) struct Scope<'a> {
    pub(super) length_unit: LengthUnit,
    pub(super) angle_unit: AngleUnit,
    pub(super) names: Vec<Name>,
    pub(super) params: Vec<OpenParam>,
    /// The names that are bound further down.
    later: &'a [Binding],
}

impl<'a> Scope<'a> {
    /// Binds every `let` and `param` of the declaration.
    pub(super) fn new(decl: &'a Decl, report: &mut Report) -> Scope<'a> {
        let mut scope = Scope {
            length_unit: decl.length_unit.unwrap_or(LengthUnit::Metre),
            angle_unit: decl.angle_unit.unwrap_or(AngleUnit::Degree),
            names: Vec::new(),
            params: Vec::new(),
            later: &decl.bindings,
        };
        for (i, binding) in decl.bindings.iter().enumerate() {
            scope.later = decl.bindings.get(i + 1..).unwrap_or(&[]);
            scope.bind(binding, report);
        }
        scope
    }

    fn bind(&mut self, binding: &Binding, report: &mut Report) {
        let (name, place) = (&binding.name.value, binding.name.place);
        name_is_free(name, place, report);
        let what = if binding.param { "the nominal value of a `param`" } else { "a `let`" };
        let value = binding.value.as_ref().and_then(|e| self.constant(e, what, report));
        if self.find(name).is_some() {
            report.error_help(place, format!("`{name}` is bound twice"), "give one of them another name");
            return;
        }
        let meaning = if binding.param {
            let kind = match value.as_ref().map(|v| &v.constant) {
                Some(Constant::Length(..)) => Some(ParamKind::Length),
                Some(Constant::Angle(_)) => Some(ParamKind::Angle),
                _ => None,
            };
            self.params.push(OpenParam { name: name.clone(), place, nominal: value, kind });
            Meaning::Param(self.params.len() - 1)
        } else {
            Meaning::Let(value)
        };
        self.names.push(Name { text: name.clone(), place, meaning, used: false });
    }

    pub(super) fn find(&self, text: &str) -> Option<usize> {
        self.names.iter().position(|n| n.text == text)
    }

    /// Whether the name stands for a joint variable and is bound all the same, which has been reported.
    pub(super) fn refused(&self, text: &str) -> bool {
        is_joint_variable(text) && self.find(text).is_some()
    }

    /// What a name amounts to in an expression; `None` if it, or its value, is unknown, which has been reported.
    pub(super) fn look_up(&mut self, text: &str, place: Place, report: &mut Report) -> Option<Value> {
        let Some(index) = self.find(text) else {
            self.unknown(text, place, report);
            return None;
        };
        let name = &mut self.names[index];
        name.used = true;
        match &name.meaning {
            Meaning::Let(value) => {
                value.clone().map(|v| Value { lets: Some(vec![(1, index)]), ..v }.zero_is_written())
            }
            Meaning::Param(param) => {
                let nominal = self.params.get(*param)?.nominal.as_ref()?;
                let constant = match nominal.constant {
                    Constant::Length(..) => Constant::Length(Scalar::zero(), 1),
                    Constant::Angle(_) => Constant::Angle(Default::default()),
                    _ => Constant::Open,
                };
                Some(Value { params: vec![(Ratio::ONE, *param)], ..Value::constant(constant) })
            }
        }
    }

    fn unknown(&self, text: &str, place: Place, report: &mut Report) {
        if self.later.iter().any(|b| b.name.value == text) {
            return report.error_help(
                place,
                format!("`{text}` is bound only further down"),
                "move its `let` up",
            );
        }
        let known = self.names.iter().map(|n| n.text.as_str());
        let help = match nearest(text, known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("bind it with `let {text} = …;` or `param {text} = …;`"),
        };
        report.error_help(place, format!("`{text}` is not bound"), help);
    }

    /// Notes that a parameter is used as a length or as an angle; both at once is a mistake.
    pub(super) fn use_param(&mut self, index: usize, kind: ParamKind, place: Place, report: &mut Report) {
        let Some(param) = self.params.get_mut(index) else { return };
        let known = *param.kind.get_or_insert(kind);
        if known != kind {
            let word = |k| if k == ParamKind::Length { "a length" } else { "an angle" };
            let message = format!("`{}` is {} elsewhere and {} here", param.name, word(known), word(kind));
            report.error_help(place, message, "declare two parameters");
        }
    }

    /// Warns of names that nothing refers to.
    pub(super) fn unused(&self, report: &mut Report) {
        for name in self.names.iter().filter(|n| !n.used && !n.text.starts_with('_')) {
            let help = format!("remove it, or name it `_{}`", name.text);
            report.warn(name.place, format!("`{}` is never used", name.text), help);
        }
    }

    /// The parameters with their kinds; one that nothing uses is a length unless its value says otherwise.
    pub(super) fn finished_params(&self, report: &mut Report) -> Vec<Param> {
        let mut done = Vec::new();
        for open in &self.params {
            let Some(value) = &open.nominal else { continue };
            let kind = open.kind.unwrap_or(ParamKind::Length);
            let nominal = match kind {
                ParamKind::Length => self.as_length(value),
                ParamKind::Angle => self.as_angle(value).map(super::measure::radians),
            };
            match nominal {
                Ok(nominal) => {
                    done.push(Param { name: open.name.clone(), kind, nominal, place: open.place });
                }
                Err(fault) => fault.report(open.place, report),
            }
        }
        done
    }
}

/// Whether a name may be bound at all.
pub(super) fn name_is_free(name: &str, place: Place, report: &mut Report) {
    let help = "choose another name";
    if is_joint_variable(name) {
        report.error_help(place, format!("`{name}` stands for a joint variable"), help);
    } else if ["pi", "sqrt", "sin", "cos"].contains(&name) {
        report.error_help(place, format!("`{name}` has its usual meaning"), help);
    } else if Unit::from_word(name).is_some() {
        report.error_help(place, format!("`{name}` is a unit"), help);
    } else if RUST.contains(&name) || name.contains('#') {
        report.error_help(place, format!("`{name}` is a word of the Rust language"), help);
    } else if !name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') {
        report.error_help(place, format!("`{name}` is not written in ASCII"), help);
    }
}
