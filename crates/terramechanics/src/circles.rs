//! On which circle is the slip counted, and on which the shear displacement? Two conventions that lugs make visible.
//!
//! A wheel with lugs has three circles: the rim r, the shearing radius r_s = r + λ_s h (letter, Eq. 9) and the lug tips r + h.
//! Without lugs they are one, and nothing here changes a number.
//!
//! | quantity | here |
//! |---|---|
//! | v/ω = (1 − s) r_slip driving, r_slip/(1 + s) braking (letter, Eq. 2) | [`Circles::travel_per_turn`] |
//! | j(θ) = r_j (θ1' − θ) − (v/ω)(sin θ1' − sin θ), θ1' = arccos((r − z)/r_j) (letter, Eq. 6) | `patch.rs` |
//!
//! Departure: Eq. (6) counts the displacement on the rim, while (9) and (10) let the shear stress act at r_s. One body of soil
//! cannot slide on two circles, so it is counted where the stress acts unless asked otherwise (erratum 13). Only j changes: σ, the
//! angles and the limits of the integrals stay those of the rim.
//!
//! Published tests differ in the circle of their slip, too: Ding et al. 2011 (source 6) count it on the shearing circle, others on
//! the lug tips. Laws that depend on slip take it as it was counted.

use crate::numerics::elementary::Number;
use crate::slip::Slip;
use crate::wheel::Wheel;

/// The circle on which the shear displacement is counted (erratum 13).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ShearDisplacementRadius {
    /// The shearing radius r_s, where the shear stress acts.
    #[default]
    Shearing,
    /// The rim r: Eq. (6) to the letter.
    Rim,
}

impl ShearDisplacementRadius {
    /// The radius r_j (m) of `wheel`.
    #[must_use]
    pub fn of(self, wheel: &Wheel) -> f64 {
        match self {
            Self::Shearing => wheel.shearing_radius(),
            Self::Rim => wheel.radius(),
        }
    }

    /// What it lies outside the rim by (m), with all its digits.
    fn offset(self, wheel: &Wheel) -> f64 {
        match self {
            Self::Shearing => wheel.shearing_offset(),
            Self::Rim => 0.0,
        }
    }
}

/// The circle whose speed the slip compares with the speed of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SlipRadius {
    /// The rim r: Eq. (2) of the letter.
    #[default]
    Rim,
    /// The shearing radius r_s, as Ding et al. 2011 count it.
    Shearing,
    /// The lug tips, r + h.
    LugTip,
}

impl SlipRadius {
    /// The radius r_slip (m) of `wheel`.
    #[must_use]
    pub fn of(self, wheel: &Wheel) -> f64 {
        match self {
            Self::Rim => wheel.radius(),
            Self::Shearing => wheel.shearing_radius(),
            Self::LugTip => wheel.lug_tip_radius(),
        }
    }

    /// What it lies outside the rim by (m), with all its digits.
    fn offset(self, wheel: &Wheel) -> f64 {
        match self {
            Self::Rim => 0.0,
            Self::Shearing => wheel.shearing_offset(),
            Self::LugTip => wheel.lug_height(),
        }
    }
}

/// The circles on which displacement and slip are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Circles {
    /// Of the shear displacement.
    pub shear_displacement: ShearDisplacementRadius,
    /// Of the slip.
    pub slip: SlipRadius,
}

impl Circles {
    /// The displacement where the shear stress acts, the slip of the rim.
    pub const SHEARING: Self = Self { shear_displacement: ShearDisplacementRadius::Shearing, slip: SlipRadius::Rim };

    /// Both on the rim: the letter to the letter.
    pub const RIM: Self = Self { shear_displacement: ShearDisplacementRadius::Rim, slip: SlipRadius::Rim };

    /// Way v/ω (m) of the axle while the wheel turns by one radian; infinite for a locked wheel. Eq. (2).
    ///
    /// ```
    /// # use terramechanics::{Circles, Slip, SlipRadius, Wheel, WheelParams};
    /// let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.05, lug_coefficient: 0.5 })?;
    /// // By hand: 0.8 · 0.25 m on the lug tips, and 0.2/0.8 m on the rim of a braking wheel.
    /// let tips = Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING };
    /// assert!((tips.travel_per_turn(&wheel, Slip::new(0.2)?) - 0.2).abs() < 1e-15);
    /// assert!((Circles::RIM.travel_per_turn(&wheel, Slip::new(-0.2)?) - 0.25).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn travel_per_turn(&self, wheel: &Wheel, slip: Slip) -> f64 {
        let (radius, s) = (self.slip.of(wheel), slip.ratio());
        if slip.is_driving() { (1.0 - s) * radius } else { radius / (1.0 + s) }
    }
}

/// How the circle of the displacement moves at one slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Kinematics<K = f64> {
    /// Its radius r_j (m).
    pub(crate) radius: K,
    /// r_j − r (m).
    pub(crate) offset: K,
    /// κ = v/(r_j ω); infinite for a locked wheel.
    pub(crate) ratio: K,
    /// 1 − κ, without cancellation near rolling where both circles are one.
    pub(crate) complement: K,
    /// 1 − 1/κ: the skid of that circle, above 0 where it is slower than the wheel travels, 1 for a locked wheel.
    pub(crate) skid: K,
}

/// The circles of a wheel, as far as its motion asks.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rings<K = f64> {
    /// r_j (m), and r_j − r (m) with all its digits.
    pub(crate) radius: K,
    pub(crate) offset: K,
    /// ρ = r_slip/r_j, and 1 − ρ with all its digits.
    pub(crate) rho: K,
    pub(crate) lead: K,
}

impl Rings {
    #[inline]
    pub(crate) fn of(circles: Circles, wheel: &Wheel) -> Self {
        let Circles { shear_displacement, slip } = circles;
        let (radius, offset) = (shear_displacement.of(wheel), shear_displacement.offset(wheel));
        Self { radius, offset, rho: slip.of(wheel) / radius, lead: (offset - slip.offset(wheel)) / radius }
    }
}

impl<K: Number> Kinematics<K> {
    /// The motion at a `slip` ratio (–). Braking κ = ρ/(1 + s), where the printed Eq. (6) has 1 − s (erratum 11: Eq. 2 gives the
    /// other), with ρ = r_slip/r_j.
    #[inline(always)]
    pub(crate) fn at(rings: &Rings<K>, slip: K) -> Self {
        let Rings { radius, offset, rho, lead } = *rings;
        let (driving, braking) = ((-slip + 1.0) * rho, rho / (slip + 1.0));
        let (driving_complement, braking_complement) = (lead + rho * slip, (lead + slip) / (slip + 1.0));
        Self {
            radius,
            offset,
            ratio: slip.if_not_negative(driving, braking),
            complement: slip.if_not_negative(driving_complement, braking_complement),
            skid: -slip.if_not_negative(driving_complement / driving, (lead + slip) / rho),
        }
    }
}

impl Kinematics {
    /// The motion at `slip`.
    #[inline]
    pub(crate) fn of(circles: Circles, wheel: &Wheel, slip: Slip) -> Self {
        Self::at(&Rings::of(circles, wheel), slip.ratio())
    }

    /// The slip at which the circle of the displacement has `skid` from 0 to 1.
    pub(crate) fn slip_ratio_at(circles: Circles, wheel: &Wheel, skid: f64) -> f64 {
        let Rings { rho, lead, .. } = Rings::of(circles, wheel);
        let excess = -(lead + rho * skid); // r_slip ω/v − 1
        if excess > 0.0 { excess / (1.0 + excess) } else { excess.max(-1.0) }
    }
}
