//! The circles on which displacement and slip are counted, which lugs part.

use terramechanics::{Circles, Method, ShearDisplacementRadius, SlipRadius};
use terramechanics_reading::{Field, Group, Reader, Word};

const SHEAR_DISPLACEMENT_WORDS: Word<ShearDisplacementRadius> =
    Word::new(&[("shearing", ShearDisplacementRadius::Shearing), ("rim", ShearDisplacementRadius::Rim)]);
const SLIP_WORDS: Word<SlipRadius> =
    Word::new(&[("rim", SlipRadius::Rim), ("shearing", SlipRadius::Shearing), ("lug_tip", SlipRadius::LugTip)]);

pub(super) const SHEAR_DISPLACEMENT: Field<Word<ShearDisplacementRadius>> = Field::new(
    "shear_displacement_radius",
    "Circle on which the shear displacement is counted: shearing, the radius r_s where the shear stress acts, or rim, as the letter prints it (erratum 13). Without lugs both are one.",
    SHEAR_DISPLACEMENT_WORDS.or(Circles::SHEARING.shear_displacement),
);
const SLIP: Field<Word<SlipRadius>> = Field::new(
    "slip_radius",
    "Circle whose speed the slip compares with the speed of travel: rim, the radius r; shearing, r_s; or lug_tip, r + h. Velocities become the slip of that circle. Without lugs all are one.",
    SLIP_WORDS.or(Circles::SHEARING.slip),
);

pub(crate) const CIRCLES: Group = &[&SHEAR_DISPLACEMENT, &SLIP];

/// The same of a variant, which has no defaults of its own.
const VARIED_SHEAR_DISPLACEMENT: Field<Word<ShearDisplacementRadius>> =
    Field { kind: SHEAR_DISPLACEMENT_WORDS, ..SHEAR_DISPLACEMENT };
const VARIED_SLIP: Field<Word<SlipRadius>> = Field { kind: SLIP_WORDS, ..SLIP };

pub(crate) const VARIED_CIRCLES: Group = &[&VARIED_SHEAR_DISPLACEMENT, &VARIED_SLIP];

/// The circles; the displacement where the shear stress acts and the slip of the rim unless others were sent.
pub(crate) fn read(object: &Reader<'_>) -> Option<Circles> {
    let (shear_displacement, slip) = (object.or_default(&SHEAR_DISPLACEMENT), object.or_default(&SLIP));
    Some(Circles { shear_displacement: shear_displacement?, slip: slip? })
}

/// The circles on which a method counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Counted {
    /// None where the method knows no shear displacement.
    shear_displacement: Option<ShearDisplacementRadius>,
    slip: SlipRadius,
}

impl Counted {
    /// By `method`; the stresses of dry grains follow from where the rim moves, not from how far it has sheared the soil.
    pub(crate) fn by(method: &Method, circles: Circles) -> Self {
        let shear_displacement = (*method != Method::ResistiveForce).then_some(circles.shear_displacement);
        Self { shear_displacement, slip: circles.slip }
    }
}

impl From<Circles> for Counted {
    fn from(Circles { shear_displacement, slip }: Circles) -> Self {
        Self { shear_displacement: Some(shear_displacement), slip }
    }
}

/// The words for circles: of the shear displacement, where it is counted, and of the slip.
pub(crate) fn words(Counted { shear_displacement, slip }: Counted) -> (Option<&'static str>, &'static str) {
    (shear_displacement.map(|circle| word(&SHEAR_DISPLACEMENT_WORDS, circle)), word(&SLIP_WORDS, slip))
}

fn word<T: Copy + PartialEq>(of: &Word<T>, value: T) -> &'static str {
    of.words.iter().find(|(_, known)| *known == value).map_or("", |(word, _)| word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_circle_has_a_word() {
        for shear_displacement in [ShearDisplacementRadius::Shearing, ShearDisplacementRadius::Rim] {
            for slip in [SlipRadius::Rim, SlipRadius::Shearing, SlipRadius::LugTip] {
                let (of_displacement, of_slip) = words(Circles { shear_displacement, slip }.into());
                let has_words = of_displacement.is_some_and(|word| !word.is_empty()) && !of_slip.is_empty();
                assert!(has_words, "{shear_displacement:?} {slip:?}");
            }
        }
    }
}
