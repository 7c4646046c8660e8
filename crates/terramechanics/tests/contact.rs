//! The exit of a contact and the interface of a rim: limits, a peer's figures, and what is refused.

mod common;

use common::{LETTER_SOIL, LETTER_WHEEL, forces, slip, system};
use proptest::prelude::*;
use terramechanics::{
    AngleRatio, Bekker, Bulldozing, Contact, ContactParams, Coupled, Error, ExitRule, ForceModel, Interface, JanosiHanamoto,
    Method, NormalStressRadius, PeakRule, PressureSinkage, ShearCoupling, ShearLaw, SideSlip, SinkageExponent, SinkageRatio,
    SlipAngle, SoilParams, WheelOnSoil, WheelParams, WongReece,
};

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;
/// Nine digits printed.
const PRINTED: f64 = 2e-9;

fn with_exit(exit: ExitRule) -> Contact {
    let rule = PeakRule::WongReece(WongReece { c1: 0.4, c2: 0.15 });
    Contact::new(ContactParams { rule, exit, ..ContactParams::MIDPOINT }).expect("a contact")
}

fn with_interface(interface: Interface) -> Contact {
    Contact::new(ContactParams { interface: Some(interface), ..ContactParams::MIDPOINT }).expect("a contact")
}

/// A wheel whose soil stands 10 % higher behind it than ahead, by either rule; the figures are an independent integration's.
#[test]
fn an_exit_beyond_the_mirrored_entry_by_ratio_and_by_angle() {
    let exponent = SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None };
    let soil = SoilParams {
        cohesion: 800.0,
        friction_angle: 0.649_262_482,
        shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.025 })),
        pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: 1370.0, k_phi: 814_000.0, exponent })),
        ..LETTER_SOIL
    };
    let wheel = WheelParams { radius: 0.15, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 };
    let by_ratio = ExitRule::SinkageRatio(SinkageRatio { ratio: 1.1 });
    let by_angle = ExitRule::AngleRatio(AngleRatio { c3: -1.049_468_687 });
    for exit in [by_ratio, by_angle] {
        let found = forces(&system(wheel, soil, with_exit(exit)), 0.4, 0.011, Method::Quadrature);
        for (found, printed) in [(found.longitudinal, 22.019_002_0), (found.normal, 45.972_296_2), (found.torque, 3.687_509_81)] {
            assert!((found / printed - 1.0).abs() <= PRINTED, "{exit:?}: {found}, not {printed}");
        }
    }
}

proptest! {
    /// η = 0 is the lowest point and η = 1 the mirrored entry, whatever the sinkage; between, the depth behind is η z.
    #[test]
    fn the_ratio_of_sinkages_places_the_exit(depth_ratio in 1e-6..=1.0, ratio in 0.0..=1.2, s in 0.0..0.5) {
        let angles = |exit| with_exit(exit).angles(depth_ratio, slip(s)).expect("angles");
        let by_ratio = |ratio| ExitRule::SinkageRatio(SinkageRatio { ratio });
        prop_assert_eq!(angles(by_ratio(0.0)), angles(ExitRule::LOWEST_POINT));
        prop_assert_eq!(angles(by_ratio(1.0)), angles(ExitRule::AngleRatio(AngleRatio { c3: -1.0 })));
        let exit = angles(by_ratio(ratio)).exit;
        // 1 − cos θ2 = η z/r, as a product.
        prop_assert!((2.0 * (0.5 * exit).sin().powi(2) - ratio * depth_ratio).abs() <= 1e-15 + ROUNDING * ratio * depth_ratio);
        prop_assert!(exit <= 0.0);
    }

    /// What an interface has of the soil changes no bit of any method.
    #[test]
    fn an_interface_like_the_soil_reproduces_the_soil(
        (cohesion, friction_angle, modulus) in (0.0..3000.0, 0.0..1.0, 0.001..0.05),
        (ratio, log_depth, lug_height) in (-1.0..=1.0, -4.0..-0.1, prop_oneof![Just(0.0), 0.001..0.02]),
    ) {
        let shear = Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus }));
        let soil = SoilParams { cohesion, friction_angle, shear, unit_weight: Some(1.5e4), ..LETTER_SOIL };
        let wheel = WheelParams { lug_height, ..LETTER_WHEEL };
        let own = Interface { friction_angle: Some(friction_angle), adhesion: Some(cohesion), shear_modulus: Some(modulus) };
        let bare = system(wheel, soil, Contact::MIDPOINT);
        let likes = [own, Interface::default()].map(|interface| system(wheel, soil, with_interface(interface)));
        let sinkage = wheel.radius * 10f64.powf(log_depth);
        let side = |coupling| {
            let angle = SlipAngle::new(-0.2).expect("an angle");
            Method::SideSlipping(SideSlip { angle, coupling, bulldozing: Bulldozing::Mobilised })
        };
        let [independent, coupled] = [ShearCoupling::Independent, ShearCoupling::Coupled].map(side);
        for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT, independent, coupled] {
            for like in &likes {
                prop_assert_eq!(forces(like, ratio, sinkage, method), forces(&bare, ratio, sinkage, method));
            }
        }
        let from_load = |system: &WheelOnSoil| {
            let rolling = system.rolling(slip(ratio))?;
            let known = Coupled { normal_load: 50.0, torque: None, normal_stress_radius: NormalStressRadius::Rim };
            known.forces(&rolling.contact(sinkage)?)
        };
        prop_assert_eq!(from_load(&likes[0]), from_load(&bare));
    }

    /// An interface changes τ and nothing else: the forces are those of a soil with its values.
    #[test]
    fn an_interface_gives_the_shear_stress_of_a_soil_with_its_values(
        (ratio, sinkage) in (-1.0..=1.0, 0.001..0.1), (share, modulus) in (0.0..=1.0, 0.001..0.05),
    ) {
        let soil = SoilParams { cohesion: 900.0, ..LETTER_SOIL };
        let (adhesion, angle) = (share * soil.cohesion, share * soil.friction_angle);
        let interface =
            Interface { friction_angle: Some(angle), adhesion: Some(adhesion), shear_modulus: Some(modulus) };
        let shear = Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus }));
        let slippery = SoilParams { cohesion: adhesion, friction_angle: angle, shear, ..soil };
        for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
            let found = forces(&system(LETTER_WHEEL, soil, with_interface(interface)), ratio, sinkage, method);
            prop_assert_eq!(found, forces(&system(LETTER_WHEEL, slippery, Contact::MIDPOINT), ratio, sinkage, method));
        }
    }
}

#[test]
fn an_interface_stronger_than_the_soil_is_refused() {
    let soil = SoilParams { cohesion: 500.0, ..LETTER_SOIL };
    let refused = |interface| system(LETTER_WHEEL, soil, with_interface(interface)).rolling(slip(0.1)).map(|_| ());
    let adhesive = Interface { adhesion: Some(500.1), ..Interface::default() };
    let expected = Error::InterfaceBeyondSoil { parameter: &Interface::ADHESION, value: 500.1, soil: 500.0 };
    assert_eq!(refused(adhesive), Err(expected));
    let rough = Interface { friction_angle: Some(0.48), ..Interface::default() };
    let expected = Error::InterfaceBeyondSoil { parameter: &Interface::FRICTION_ANGLE, value: 0.48, soil: 0.478 };
    assert_eq!(refused(rough), Err(expected));
    // A displacement modulus may be larger or smaller than the soil's.
    assert_eq!(refused(Interface { shear_modulus: Some(1.0), ..Interface::default() }), Ok(()));
    for value in [-1.0, f64::NAN] {
        let params = |interface| Contact::new(ContactParams { interface: Some(interface), ..ContactParams::MIDPOINT });
        let all = Interface { friction_angle: Some(value), adhesion: Some(value), shear_modulus: Some(value) };
        let faults: Vec<_> = params(all).expect_err("refused").faults.iter().map(|fault| fault.parameter.name).collect();
        assert_eq!(faults, ["friction_angle_rad", "adhesion_pa", "shear_modulus_m"]);
    }
}

/// The wedge beside the wheel and the place where two zones part are the soil's: an interface leaves them.
#[test]
fn an_interface_leaves_the_soil_beside_the_rim_alone() {
    let interface = Interface { friction_angle: Some(0.2), adhesion: Some(0.0), shear_modulus: None };
    let soil = SoilParams { cohesion: 700.0, unit_weight: Some(1.6e4), ..LETTER_SOIL };
    let side = SideSlip::independent(SlipAngle::new(0.3).expect("an angle"));
    let bulldozing = |contact| {
        let found = forces(&system(LETTER_WHEEL, soil, contact), 0.2, 0.02, Method::SideSlipping(side)).side.expect("a side");
        (found.bulldozing, found.shear)
    };
    let (bare, slippery) = (bulldozing(Contact::MIDPOINT), bulldozing(with_interface(interface)));
    assert_eq!(bare.0, slippery.0);
    assert!(slippery.1 < bare.1);
    let parted = |contact: Contact| {
        let system = system(LETTER_WHEEL, soil, contact.with_braking(terramechanics::Braking::TwoZone));
        let rolling = system.rolling(slip(-0.1)).expect("a rolling wheel");
        rolling.contact(0.05).expect("a contact").angles.peak
    };
    assert_eq!(parted(Contact::MIDPOINT), parted(with_interface(interface)));
    let curve = |contact| system(LETTER_WHEEL, soil, contact).curve(slip(0.1)).expect("a curve");
    assert_eq!(curve(Contact::MIDPOINT), curve(with_interface(interface)));
    let model = ForceModel::at_rim(Method::Quadrature);
    let pull = |contact| {
        let system = system(LETTER_WHEEL, soil, contact);
        let rolling = system.rolling(slip(0.3)).expect("a rolling wheel");
        model.solve_sinkage(&rolling, 60.0).expect("a balance").forces.longitudinal
    };
    assert!(pull(with_interface(interface)) < pull(Contact::MIDPOINT));
}
