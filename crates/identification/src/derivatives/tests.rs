use super::*;
use crate::consent::Consent;
use crate::observations::{Column, Observations};
use crate::options::FitOptions;
use crate::unknown::Unknown;
use terramechanics::{
    ContactParams, Direct, ForceModel, JanosiHanamoto, Method, PeakRule, PressureSinkage, ShearLaw, SinkageExponent, Slip,
    SoilParams, Wheel, WheelParams, WongReece,
};

/// Tolerance for derivatives: the truncation error of the coarser ones, with a step of 1e-4.
const AGREED: f64 = 1e-6;

fn setup(method: Method) -> Setup {
    let exponent = SinkageExponent { base: 0.9, slip_gain: 0.3, skid_gain: None };
    Setup {
        wheel: Wheel::new(WheelParams { radius: 0.15, width: 0.12, lug_height: 0.008, lug_coefficient: 0.5 }).expect("a wheel"),
        soil: SoilParams {
            cohesion: 600.0,
            friction_angle: 0.55,
            shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.012 })),
            pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 9e5, exponent })),
            ..SoilParams::BARE
        },
        contact: ContactParams { rule: PeakRule::WongReece(WongReece { c1: 0.45, c2: 0.1 }), ..ContactParams::MIDPOINT },
        model: ForceModel::at_rim(method),
        sinkage: SinkageSource::Load,
    }
}

/// The derivatives under a load, by the implicit function, against differences of whole load balances.
#[test]
fn derivatives_under_a_load_are_those_of_solved_sinkages() {
    let column = |values: Vec<f64>| Some(Column { values, deviation: None });
    let observations = Observations {
        slip: [-0.1, 0.05, 0.3, 0.7].map(|ratio| Slip::new(ratio).expect("a slip")).to_vec(),
        sinkage: column(vec![0.01; 4]),
        longitudinal: column(vec![10.0; 4]),
        normal: column(vec![40.0, 60.0, 90.0, 120.0]),
        torque: column(vec![5.0; 4]),
    };
    for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
        let setup = setup(method);
        let has = |unknown: &Unknown| unknown.value(&setup).is_some();
        let sought: Vec<Sought> =
            Unknown::ALL.into_iter().filter(has).map(|unknown| Sought::from_setup(unknown, &setup)).collect();
        let consent = Consent::new(&|| true);
        let problem = Problem::new(setup, &observations, &sought, &FitOptions::default(), &consent).expect("a problem");
        let values: Vec<f64> = sought.iter().map(|one| one.start).collect();
        let all: Vec<usize> = (0..values.len()).collect();
        let base = problem.predictions(&values).expect("predictions");
        let jacobian = problem.jacobian(&values, &base, &all).expect("derivatives");
        for (i, scale) in problem.scales.iter().enumerate() {
            // λ may stand at 0, where it can go to either side like the others.
            let at = |shift: f64| {
                let mut values = values.clone();
                values[i] = scale.outward(scale.inward(values[i]) + shift);
                problem.weighted(&problem.predictions(&values).expect("predictions")).expect("residuals")
            };
            let difference = (at(1e-4) - at(-1e-4)) / 2e-4;
            let error = (jacobian.column(i) - &difference).norm() / difference.norm().max(1e-3);
            assert!(error < AGREED, "{method:?} {}: {error}", sought[i].unknown);
        }
    }
}
