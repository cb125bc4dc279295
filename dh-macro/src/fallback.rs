//! The arm's shape after a mistake: the struct's fields and the traits it would have, so that the rest of the program
//! does not complain about their absence. One mistake, one message.

use kin_gen::decl::{self, Content, Decl, Expr, is_joint_variable};
use kin_gen::report::Report;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::shell::Field;
use crate::tokens::Tokens;

/// What can still be said of an arm that was not derived.
pub(crate) struct Outline {
    /// The fields of the struct.
    pub(crate) fields: Vec<Field>,
    joints: usize,
}

impl Outline {
    /// Reads the declaration once more; its mistakes have been told already.
    pub(crate) fn of(tokens: &Tokens) -> Outline {
        let Some(decl) = decl::parse(&tokens.list, &mut Report::new()) else {
            return Outline { fields: Vec::new(), joints: 0 };
        };
        let params = decl.bindings.iter().filter(|binding| binding.param).map(|binding| &binding.name.value);
        Outline {
            fields: params
                .map(|name| Field { name: tokens.param(name), doc: "A parameter.".to_owned() })
                .collect(),
            // Where rows were lost, each joint still has its q.
            joints: if decl.whole {
                joints(&decl)
            } else {
                tokens.list.iter().filter(|token| is_joint_variable(&token.text)).count()
            },
        }
    }

    /// The implementations. They are never called: the program does not compile.
    pub(crate) fn items(&self, name: &Ident, krate: &TokenStream) -> TokenStream {
        let inherent = inherent(name, &self.fields);
        let arm = arm(name, krate, self.joints);
        let inverse = match self.joints {
            3 => position_inverse(name, krate),
            6 => pose_inverse(name, krate),
            _ => TokenStream::new(),
        };
        quote!(#inherent #arm #inverse)
    }
}

/// How many joints the author seems to mean: a row or factor with a q is one, and so is a row with a name.
fn joints(decl: &Decl) -> usize {
    let moves = |expr: &Expr| expr.mentions(&is_joint_variable);
    let rows = decl.table.iter().flat_map(|table| &table.rows).filter(|row| {
        row.cells.iter().any(|cell| match &cell.content {
            Content::Name(_) => true,
            Content::Value(expr) => moves(expr),
            Content::Empty | Content::Range(..) | Content::Bad => false,
        })
    });
    let factors = decl.factors.iter().filter(|factor| factor.argument.as_ref().is_some_and(moves));
    rows.count() + factors.count()
}

fn inherent(name: &Ident, fields: &[Field]) -> TokenStream {
    let values = fields.iter().map(|Field { name, .. }| quote!(#name: 0.0));
    quote! {
        impl #name {
            #[doc = "The nominal arm."]
            pub const NOMINAL: Self = Self { #(#values),* };
        }
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self::NOMINAL
            }
        }
    }
}

fn arm(name: &Ident, krate: &TokenStream, joints: usize) -> TokenStream {
    quote! {
        impl #krate::Arm<#joints> for #name {
            const NAME: &'static str = "";
            const LENGTH_UNIT: #krate::LengthUnit = #krate::LengthUnit::Metre;
            const TABLE: &'static str = "";
            const JOINTS: [#krate::Joint; #joints] =
                [#krate::Joint { name: "", kind: #krate::JointKind::Revolute }; #joints];
            fn reach(&self) -> f64 {
                ::core::unreachable!()
            }
            fn limits(&self) -> #krate::Limits<#joints> {
                ::core::unreachable!()
            }
            fn fk<T: #krate::Real>(&self, _: &#krate::Joints<T, #joints>) -> #krate::Pose<T> {
                ::core::unreachable!()
            }
            fn frames<T: #krate::Real>(&self, _: &#krate::Joints<T, #joints>) -> [#krate::Pose<T>; #joints] {
                ::core::unreachable!()
            }
            fn jacobian<T: #krate::Real>(&self, _: &#krate::Joints<T, #joints>) -> #krate::Jacobian<T, #joints> {
                ::core::unreachable!()
            }
            fn fk_jacobian<T: #krate::Real>(
                &self,
                _: &#krate::Joints<T, #joints>,
            ) -> (#krate::Pose<T>, #krate::Jacobian<T, #joints>) {
                ::core::unreachable!()
            }
        }
    }
}

fn pose_inverse(name: &Ident, krate: &TokenStream) -> TokenStream {
    quote! {
        impl #krate::SphericalWrist<6> for #name {
            fn r36<T: #krate::Real>(&self, _: T, _: T, _: T) -> #krate::Matrix3<T> {
                ::core::unreachable!()
            }
            fn r03<T: #krate::Real>(&self, _: T, _: T, _: T) -> (#krate::Matrix3<T>, #krate::Point3<T>) {
                ::core::unreachable!()
            }
            fn wrist_angles<T: #krate::Float>(&self, _: &#krate::Matrix3<T>) -> #krate::Wrist<T> {
                ::core::unreachable!()
            }
        }
        impl #krate::InverseKinematics<6> for #name {
            type Branch = #krate::Posture;
            fn ik<T: #krate::Float>(&self, _: &#krate::Pose<T>) -> #krate::Solutions<T, 6, #krate::Posture> {
                ::core::unreachable!()
            }
            fn ik_holding<T: #krate::Float>(
                &self,
                _: &#krate::Pose<T>,
                _: &#krate::Joints<T, 6>,
            ) -> #krate::Solutions<T, 6, #krate::Posture> {
                ::core::unreachable!()
            }
        }
    }
}

fn position_inverse(name: &Ident, krate: &TokenStream) -> TokenStream {
    quote! {
        impl #krate::PositionInverse<3> for #name {
            type Branch = #krate::ArmPosture;
            fn ik_position<T: #krate::Float>(
                &self,
                _: &#krate::Point3<T>,
            ) -> #krate::Solutions<T, 3, #krate::ArmPosture> {
                ::core::unreachable!()
            }
            fn ik_position_holding<T: #krate::Float>(
                &self,
                _: &#krate::Point3<T>,
                _: &#krate::Joints<T, 3>,
            ) -> #krate::Solutions<T, 3, #krate::ArmPosture> {
                ::core::unreachable!()
            }
        }
    }
}
