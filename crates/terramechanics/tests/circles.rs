//! The circles on which slip and displacement are counted: one without lugs, and with them by hand.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, contact, slip, system};
use proptest::prelude::*;
use terramechanics::{
    Braking, Bulldozing, Circles, Contact, Coupled, Error, ForceModel, JanosiHanamoto, Method, NormalStressRadius, PeakRule,
    PressureSinkage, ShearCoupling, ShearDisplacementRadius, ShearLaw, SideSlip, SinkageExponent, SlipAngle, SlipRadius,
    SoilParams, WheelOnSoil, WheelParams, WongReece,
};

/// Digits printed.
const PRINTED: f64 = 5e-9;
/// Two ways to the same double.
const ROUNDING: f64 = 1e-12;

const SLIP_CIRCLES: [SlipRadius; 3] = [SlipRadius::Rim, SlipRadius::Shearing, SlipRadius::LugTip];
const DISPLACEMENT_CIRCLES: [ShearDisplacementRadius; 2] = [ShearDisplacementRadius::Shearing, ShearDisplacementRadius::Rim];

fn all_circles() -> impl Iterator<Item = Circles> {
    let pair = |shear_displacement| SLIP_CIRCLES.map(|slip| Circles { shear_displacement, slip });
    DISPLACEMENT_CIRCLES.into_iter().flat_map(pair)
}

fn methods() -> Vec<Method> {
    let side = |coupling| {
        let angle = SlipAngle::new(0.15).expect("an angle");
        Method::SideSlipping(SideSlip { angle, coupling, bulldozing: Bulldozing::Full })
    };
    let sides = [ShearCoupling::Independent, ShearCoupling::Coupled].map(side);
    [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT].into_iter().chain(sides).collect()
}

/// A wheel of 157 mm with lugs of 10 mm on the soil on which it was tested (Ding et al. 2011).
fn lugged() -> WheelOnSoil {
    let exponent = SinkageExponent { base: 1.10, slip_gain: 0.0, skid_gain: None };
    let law = terramechanics::Bekker { k_c: 15.6e3, k_phi: 2_407.4e3, exponent };
    system(
        WheelParams { radius: 0.15735, width: 0.165, lug_height: 0.01, lug_coefficient: 0.5 },
        SoilParams {
            cohesion: 250.0,
            friction_angle: 31.9_f64.to_radians(),
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.0114 })),
            pressure_sinkage: Some(PressureSinkage::Bekker(law)),
            unit_weight: Some(1.5e4),
            ..SoilParams::BARE
        },
        Contact::MIDPOINT,
    )
}

fn on(system: &WheelOnSoil, circles: Circles) -> WheelOnSoil {
    WheelOnSoil { contact: system.contact.with_circles(circles), ..*system }
}

/// Sinkage, pull and torque at 10 % slip under 80 N by thirty digits.
#[test]
fn a_lugged_wheel_under_80_newtons_on_each_pair_of_circles() {
    let shearing = Circles { slip: SlipRadius::Shearing, ..Circles::SHEARING };
    for (circles, sinkage, pull, torque) in [
        (Circles::SHEARING, 12.129_498_7e-3, 9.311_172_87, 4.045_722_49),
        (shearing, 12.175_412_6e-3, 6.701_562_95, 3.633_701_96),
        (Circles::RIM, 12.298_054_3e-3, 0.631_188_273, 2.676_896_41),
    ] {
        let wheel = on(&lugged(), circles);
        let rolling = wheel.rolling(slip(0.1)).expect("a rolling wheel");
        let carried = ForceModel::at_rim(Method::Quadrature).solve_sinkage(&rolling, 80.0).expect("a balance");
        for (found, printed) in [(carried.sinkage, sinkage), (carried.forces.longitudinal, pull), (carried.forces.torque, torque)]
        {
            assert!((found / printed - 1.0).abs() <= PRINTED, "{circles:?}: {found}, not {printed}");
        }
    }
    assert_eq!(Contact::MIDPOINT.circles(), Circles::SHEARING);
}

/// j = r_j (θ1' − θ) − (v/ω)(sin θ1' − sin θ), as it stands, for a contact deep enough to bear the cancellation.
#[test]
fn the_displacement_is_the_formula_on_its_own_circle() {
    let wheel = lugged();
    let (r, r_s, tip, z) = (0.15735_f64, 0.16235_f64, 0.16735_f64, 0.03_f64);
    for (circles, r_j, r_slip) in [
        (Circles::SHEARING, r_s, r),
        (Circles { slip: SlipRadius::LugTip, ..Circles::SHEARING }, r_s, tip),
        (Circles { slip: SlipRadius::LugTip, ..Circles::RIM }, r, tip),
    ] {
        for s in [-0.4, -0.02, 0.0, 0.01, 0.3, 1.0] {
            let wheel = on(&wheel, circles);
            let rolling = wheel.rolling(slip(s)).expect("a rolling wheel");
            let patch = rolling.contact(z).expect("a contact");
            let travel = if s >= 0.0 { (1.0 - s) * r_slip } else { r_slip / (1.0 + s) };
            assert!((circles.travel_per_turn(&wheel.wheel, slip(s)) / travel - 1.0).abs() <= ROUNDING || travel == 0.0);
            let entry = ((r - z) / r_j).acos();
            for share in [0.0, 0.3, 0.7, 1.0] {
                let theta = share * patch.angles.entry;
                let j = r_j * (entry - theta) - travel * (entry.sin() - theta.sin());
                assert!((patch.shear_displacement(theta) - j).abs() <= ROUNDING * r_j, "{circles:?}, {s}, {share}");
            }
        }
    }
}

proptest! {
    /// Without lugs all circles are one, to the last bit.
    #[test]
    fn without_lugs_no_circle_changes_a_bit(
        (radius, log_depth, ratio) in (0.05..0.5, -4.0..0.0, -1.0..=1.0),
        (cohesion, c1, exit_ratio) in (0.0..3000.0, 0.35..0.6, -0.5..=0.2),
        two_zones in any::<bool>(),
    ) {
        let rule = PeakRule::WongReece(WongReece { c1, c2: 0.1 });
        let soil = SoilParams { cohesion, unit_weight: Some(1.6e4), ..LETTER_SOIL };
        let braking = if two_zones { Braking::TwoZone } else { Braking::OneZone };
        let plain = system(
            WheelParams { radius, ..LETTER_WHEEL },
            soil,
            contact(rule, exit_ratio).with_braking(braking),
        );
        let sinkage = radius * 10f64.powf(log_depth);
        for method in methods() {
            let forces = |circles| {
                let wheel = on(&plain, circles);
                let rolling = wheel.rolling(slip(ratio))?;
                ForceModel::at_rim(method).forces(&rolling.contact(sinkage)?)
            };
            let letters = forces(Circles::RIM);
            for circles in all_circles() {
                prop_assert_eq!(forces(circles), letters);
            }
        }
    }

    /// The slip of one circle is that of another at the same speeds: the forces then are the same. The exponent does not change
    /// with slip, nor does the place of the peak.
    #[test]
    fn one_motion_gives_the_same_forces_whatever_circle_its_slip_is_counted_on(
        (forward, sinkage_ratio, exit_ratio) in (0.2..2.0, 0.01..0.6, -1.2..=0.1),
        on_rim in any::<bool>(),
    ) {
        let wheel = WheelOnSoil { contact: contact(PeakRule::Midpoint, exit_ratio), ..lugged() };
        let sinkage = sinkage_ratio * wheel.wheel.radius();
        let velocities = terramechanics::Velocities { forward: forward * wheel.wheel.radius(), angular: 1.0 };
        let shear_displacement = DISPLACEMENT_CIRCLES[usize::from(on_rim)];
        for method in methods() {
            let forces = SLIP_CIRCLES.map(|circle| {
                let motion = terramechanics::Motion::of(&wheel.wheel, circle, velocities).expect("a motion");
                let wheel = on(&wheel, Circles { shear_displacement, slip: circle });
                let rolling = wheel.rolling(motion.slip).expect("a rolling wheel");
                ForceModel::at_rim(method).forces(&rolling.contact(sinkage).expect("a contact")).expect("forces")
            });
            for other in &forces[1..] {
                // The integral may be split elsewhere by a rounding.
                let (scale, tolerance) = (forces[0].longitudinal_scale(), 1e-10);
                prop_assert!((other.longitudinal - forces[0].longitudinal).abs() <= tolerance * scale);
                prop_assert!((other.normal - forces[0].normal).abs() <= tolerance * forces[0].normal_scale());
                prop_assert!((other.torque - forces[0].torque).abs() <= tolerance * scale);
            }
        }
    }

    /// Counted where the stress acts, a wheel that drives on its rim is sheared further, and pulls more.
    #[test]
    fn lugs_pull_more_where_the_displacement_is_counted_on_the_shearing_circle(
        ratio in 0.0..0.9, sinkage_ratio in 0.01..0.5,
    ) {
        let wheel = lugged();
        for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
            let [rim, shearing] = [Circles::RIM, Circles::SHEARING].map(|circles| {
                let wheel = on(&wheel, circles);
                let rolling = wheel.rolling(slip(ratio)).expect("a rolling wheel");
                let patch = rolling.contact(sinkage_ratio * wheel.wheel.radius()).expect("a contact");
                ForceModel::at_rim(method).forces(&patch).expect("forces")
            });
            prop_assert!(shearing.longitudinal > rim.longitudinal && shearing.torque > rim.torque);
        }
    }
}

/// The coupled forms see the displacement through E at the peak: they give the linearised method back on every circle.
#[test]
fn the_coupled_form_follows_the_circles() {
    for circles in all_circles() {
        let wheel = on(&lugged(), circles);
        for s in [-0.3, 0.0, 0.05, 0.4] {
            let rolling = wheel.rolling(slip(s)).expect("a rolling wheel");
            let patch = rolling.contact(0.012).expect("a contact");
            let linear = ForceModel::at_rim(Method::LINEARISED).forces(&patch).expect("forces");
            let known = Coupled { normal_load: linear.normal, torque: None, normal_stress_radius: NormalStressRadius::Rim };
            let coupled = known.forces(&patch).expect("forces");
            assert!((coupled.longitudinal - linear.longitudinal).abs() <= ROUNDING * linear.longitudinal_scale());
            assert!((coupled.torque - linear.torque).abs() <= ROUNDING * linear.longitudinal_scale());
        }
    }
}

/// A wheel that is towed turns as the soil turns it: its speeds do not depend on the circle of its slip.
#[test]
fn a_towed_wheel_has_one_motion_on_every_slip_circle() {
    for braking in [Braking::OneZone, Braking::TwoZone] {
        let towed = SLIP_CIRCLES.map(|circle| {
            let circles = Circles { slip: circle, ..Circles::SHEARING };
            let wheel = on(&lugged(), circles);
            let wheel = WheelOnSoil { contact: wheel.contact.with_braking(braking), ..wheel };
            let towed = wheel.solve_towed(80.0).expect("it rolls");
            assert!(towed.resistance() > 0.0 && towed.forces.torque.abs() < 1e-6);
            (circles.travel_per_turn(&wheel.wheel, towed.slip), towed)
        });
        for (travel, other) in &towed[1..] {
            assert!((travel / towed[0].0 - 1.0).abs() <= 1e-9, "{travel}");
            assert!((other.sinkage / towed[0].1.sinkage - 1.0).abs() <= 1e-8);
        }
        // On the lug tips, which run ahead of the shearing circle, it rolls with more slip than on the rim.
        assert!(towed[2].1.slip.ratio() > towed[1].1.slip.ratio() && towed[1].1.slip.ratio() > towed[0].1.slip.ratio());
    }
}

/// Two zones take a skid of the circle on which the soil is sheared.
#[test]
fn a_rim_that_skids_less_than_its_lugs_make_up_for_has_one_zone() {
    let wheel = lugged();
    let two = WheelOnSoil { contact: wheel.contact.with_braking(Braking::TwoZone), ..wheel };
    // r/r_s = 0.9692: the shearing circle skids below a slip of −0.0308.
    for (s, has_two) in [(-0.03, false), (-0.04, true)] {
        let rolling = two.rolling(slip(s)).expect("a rolling wheel");
        assert_eq!(rolling.contact(0.03).map(|patch| patch.has_two_zones()), Ok::<_, Error>(has_two));
    }
}
