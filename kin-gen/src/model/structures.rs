//! Which plans an arm needs.

use super::Work;
use crate::algebra::expr::Exprs;
use crate::algebra::frame::{Stretch, Values};
use crate::chain::{Chain, Element};
use crate::derive::wrist;
use crate::family::{self, Inverse};
use crate::plan::shape::Shape;
use crate::plan::{self, WANTED, Wanted};
use crate::program::Mismatch;
use crate::truth::{self, Symbols};

/// The structures that the arm's programs need plans of, and which outputs of each.
pub fn structures(chain: &Chain) -> Result<Vec<(Wanted, Shape)>, Mismatch> {
    let symbols = Symbols::of(chain);
    let mut ring = symbols.ring(chain);
    let outers = truth::outers(&mut ring, &symbols, chain).ok_or(Mismatch::TooLarge)?;
    let (inverse, ring) = family::recognise(chain, &symbols, ring, &outers);
    let mut work = Work { chain, symbols, outers, exprs: Exprs::new(ring) };
    let whole = work.whole_frames()?;
    let mut found = Vec::new();
    if let Some(fitted) = plan::fit(&mut work.exprs, &whole) {
        found.extend(WANTED.map(|wanted| (wanted, fitted.shape_for(wanted))));
    }
    if let Inverse::Pose(geometry) = inverse {
        let [arm, hand] = work.arm_and_hand();
        let frames = work.frames(Values::Rows, &hand)?;
        if let Some(mut fitted) = plan::fit(&mut work.exprs, &frames) {
            fitted.forget_lengths();
            found.push((Wanted::Pose, fitted.shape_for(Wanted::Pose)));
        }
        let frames = work.frames(Values::Rows, &arm)?;
        let frames = wrist::with_tip_at(&mut work.exprs, &frames, &geometry.centre_in_frame3);
        let fitted = plan::fit(&mut work.exprs, &frames);
        found.extend(fitted.map(|fitted| (Wanted::Pose, fitted.shape_for(Wanted::Pose))));
    }
    Ok(found)
}

impl<'a> Work<'a> {
    /// The chain up to the frame of joint 3, and from there to the frame of joint 6: fixed rows behind it belong to the
    /// tool's side.
    pub(super) fn arm_and_hand(&self) -> [Stretch<'a>; 2] {
        let chain = self.chain;
        let third = chain.frames.get(2).copied().unwrap_or(0);
        let sixth = chain.frames.get(5).copied().unwrap_or(chain.elements.len());
        let base: &[Element] = if self.outers.base.general { &[] } else { &chain.base };
        let arm = base.iter().chain(&chain.elements[..third]).collect();
        let hand = chain.elements[third..sixth].iter().collect();
        [arm, hand].map(|elements| Stretch { elements, frames: Vec::new() })
    }
}
