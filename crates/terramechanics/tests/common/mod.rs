//! Systems and reference cases that several test files share.
#![allow(dead_code, reason = "each test file uses its own part")]

use serde_json::Value;
use terramechanics::{
    AngleRatio, Bekker, Braking, Circles, Contact, ContactParams, Diameter, Direct, ExitRule, ForceModel, Forces, Interface,
    JanosiHanamoto, Lambda, Method, NormalStressRadius, PeakDepth, PeakRule, PressureSinkage, Reece, ShearDisplacementRadius,
    ShearLaw, SinkageExponent, SinkageRatio, Slip, SlipRadius, Soil, SoilParams, Wheel, WheelOnSoil, WheelParams, WongPeak,
    WongReece, WongResidual,
};

/// The letter's wheel and soil (its Fig. 1b), as parameters to vary.
pub(crate) const LETTER_WHEEL: WheelParams = WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 };
pub(crate) const LETTER_LAW: Bekker =
    Bekker { k_c: -660.0, k_phi: 754_130.0, exponent: SinkageExponent { base: 0.91, slip_gain: 0.0, skid_gain: None } };
pub(crate) const LETTER_SOIL: SoilParams = SoilParams {
    cohesion: 0.0,
    friction_angle: 0.478,
    shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 })),
    pressure_sinkage: Some(PressureSinkage::Bekker(LETTER_LAW)),
    ..SoilParams::BARE
};

pub(crate) fn system(wheel: WheelParams, soil: SoilParams, contact: Contact) -> WheelOnSoil {
    WheelOnSoil { wheel: Wheel::new(wheel).expect("a wheel"), soil: Soil::new(soil).expect("a soil"), contact }
}

pub(crate) fn letter() -> WheelOnSoil {
    system(LETTER_WHEEL, LETTER_SOIL, Contact::MIDPOINT)
}

pub(crate) fn contact(rule: PeakRule, exit_ratio: f64) -> Contact {
    let exit = ExitRule::AngleRatio(AngleRatio { c3: exit_ratio });
    Contact::new(ContactParams { rule, exit, ..ContactParams::MIDPOINT }).expect("a contact")
}

pub(crate) fn slip(ratio: f64) -> Slip {
    Slip::new(ratio).expect("a slip")
}

pub(crate) fn forces(system: &WheelOnSoil, ratio: f64, sinkage: f64, method: Method) -> Forces {
    let rolling = system.rolling(slip(ratio)).expect("a rolling wheel");
    ForceModel::at_rim(method).forces(&rolling.contact(sinkage).expect("a contact")).expect("forces")
}

/// The cases of a fixture, with names as in the HTTP contract.
pub(crate) fn cases(text: &str) -> Vec<Value> {
    match serde_json::from_str(text).expect("a fixture is JSON") {
        Value::Array(cases) => cases,
        other => panic!("a fixture is an array of cases, not {other}"),
    }
}

pub(crate) const REFERENCE_CASES: &str = include_str!("../reference/reference_cases.json");
pub(crate) const LUGS: &str = include_str!("../reference/lugs.json");
pub(crate) const CIRCLES: &str = include_str!("../reference/circles.json");
pub(crate) const SIDE_FORCE_CASES: &str = include_str!("../reference/side_force_cases.json");
pub(crate) const EDGE_CASES: &str = include_str!("../reference/edge_cases.json");

/// A number of a case, or what it is where the case leaves it out.
fn number(object: &Value, name: &str, default: f64) -> f64 {
    object.get(name).map_or(default, |value| value.as_f64().expect("a number"))
}

/// The circles of a case; one that says nothing of them counts on the rim, as the letter does.
fn circles_of(input: &Value) -> Circles {
    let circle = |name: &str| input.get(name).and_then(Value::as_str).unwrap_or("rim");
    Circles {
        shear_displacement: match circle("shear_displacement_radius") {
            "rim" => ShearDisplacementRadius::Rim,
            "shearing" => ShearDisplacementRadius::Shearing,
            other => panic!("no circle {other}"),
        },
        slip: match circle("slip_radius") {
            "rim" => SlipRadius::Rim,
            "shearing" => SlipRadius::Shearing,
            "lug_tip" => SlipRadius::LugTip,
            other => panic!("no circle {other}"),
        },
    }
}

fn contact_of(input: &Value, rule: PeakRule) -> Contact {
    let given = &input["contact"];
    let exit = match given.get("exit") {
        Some(exit) => ExitRule::SinkageRatio(SinkageRatio { ratio: number(exit, "ratio", f64::NAN) }),
        None => ExitRule::AngleRatio(AngleRatio { c3: number(given, "c3", 0.0) }),
    };
    let interface = given.get("interface").map(|of| {
        let value = |name: &str| of.get(name).and_then(Value::as_f64);
        Interface {
            friction_angle: value("friction_angle_rad"),
            adhesion: value("adhesion_pa"),
            shear_modulus: value("shear_modulus_m"),
        }
    });
    let contact = Contact::new(ContactParams { rule, exit, circles: circles_of(input), interface }).expect("a contact");
    let is_parted = input.get("braking").is_some_and(|braking| braking == "two_zone");
    contact.with_braking(if is_parted { Braking::TwoZone } else { Braking::OneZone })
}

pub(crate) fn system_of(input: &Value) -> WheelOnSoil {
    let (wheel, soil, law, rule) = (&input["wheel"], &input["soil"], &input["soil"]["pressure_sinkage"], &input["contact"]);
    let required = |object: &Value, name: &str| number(object, name, f64::NAN);
    let exponent = SinkageExponent { base: required(law, "n0"), slip_gain: number(law, "n1", 0.0), skid_gain: None };
    let pressure_sinkage = match law["law"].as_str() {
        Some("bekker") => PressureSinkage::Bekker(Bekker { k_c: required(law, "k_c"), k_phi: required(law, "k_phi"), exponent }),
        Some("direct") => PressureSinkage::Direct(Direct { k_s: required(law, "k_s"), exponent }),
        Some("reece") => PressureSinkage::Reece(Reece {
            k_c: required(law, "k_c"),
            k_phi: required(law, "k_phi"),
            unit_weight: required(law, "unit_weight_n_m3"),
            exponent,
        }),
        Some("diameter") => PressureSinkage::Diameter(Diameter { k: required(law, "k"), m: required(law, "m"), exponent }),
        other => panic!("no law {other:?}"),
    };
    let peak_rule = match rule["rule"].as_str() {
        Some("midpoint") | None => PeakRule::Midpoint,
        Some("wong_reece") => PeakRule::WongReece(WongReece { c1: required(rule, "c1"), c2: required(rule, "c2") }),
        Some("half_sinkage") => PeakRule::HalfSinkage,
        other => panic!("no rule {other:?}"),
    };
    let shear = &soil["shear"];
    let peak_displacement = number(shear, "peak_displacement_m", f64::NAN);
    let shear = match shear["law"].as_str() {
        None => ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: required(soil, "shear_modulus_m") }),
        Some("wong_residual") => {
            ShearLaw::WongResidual(WongResidual { residual_ratio: required(shear, "residual_ratio"), peak_displacement })
        }
        Some("wong_peak") => ShearLaw::WongPeak(WongPeak { peak_displacement }),
        other => panic!("no shear law {other:?}"),
    };
    system(
        WheelParams {
            radius: required(wheel, "radius_m"),
            width: required(wheel, "width_m"),
            lug_height: number(wheel, "lug_height_m", 0.0),
            lug_coefficient: number(wheel, "lug_coefficient", Wheel::TYPICAL_LUG_COEFFICIENT),
        },
        SoilParams {
            cohesion: required(soil, "cohesion_pa"),
            friction_angle: required(soil, "friction_angle_rad"),
            shear: Some(shear),
            pressure_sinkage: Some(pressure_sinkage),
            unit_weight: soil.get("unit_weight_n_m3").and_then(Value::as_f64),
            lateral_shear_modulus: soil.get("lateral_shear_modulus_m").and_then(Value::as_f64),
            ..SoilParams::BARE
        },
        contact_of(input, peak_rule),
    )
}

/// The force model of a case by the name of its method.
pub(crate) fn model_of(input: &Value, method: &str) -> ForceModel {
    let peak_depth = |default| match input.get("peak_sinkage").and_then(Value::as_str) {
        Some("half") => PeakDepth::Half,
        Some("geometric") => PeakDepth::Geometric,
        _ => default,
    };
    let lambda = |name: &str| match input.get(name) {
        Some(Value::String(_)) => Lambda::Exact,
        _ => Lambda::Given(number(input, name, 0.0)),
    };
    ForceModel {
        method: match method {
            "quadrature" => Method::Quadrature,
            "linearised" => Method::Linearised { peak_depth: peak_depth(PeakDepth::Geometric) },
            _ => Method::Explicit {
                peak_depth: peak_depth(PeakDepth::Half),
                lambda_a: lambda("lambda_a"),
                lambda_b: lambda("lambda_b"),
            },
        },
        normal_stress_radius: match input.get("normal_stress_radius").and_then(Value::as_str) {
            Some("shearing") => NormalStressRadius::Shearing,
            _ => NormalStressRadius::Rim,
        },
    }
}
