//! Both ways to a case lead to the same one.

use serde_json::{Value, json};

use super::*;
use crate::api::forces::ForcesCase;
use crate::request::Request;
use crate::words::HINTS;
use terramechanics_reading::Node;

fn paths(pointers: &[&str]) -> Vec<Path> {
    let path = |pointer: &&str| {
        let path = Path::of_pointer(pointer).expect("a pointer");
        ForcesCase::OBJECT.number_at(&path, &HINTS).expect("a number");
        path
    };
    pointers.iter().map(path).collect()
}

fn template(request: &Value, pointers: &[&str]) -> Template<ForcesCase> {
    Template::new(&Node::from(request), &paths(pointers)).expect("a template")
}

/// That both ways agree for all rows, and whether the short one was open.
fn agree(request: &Value, pointers: &[&str], rows: &[&[f64]]) -> bool {
    let mut template = template(request, pointers);
    let mut long = template.clone();
    for row in rows {
        long.direct = Direct::Closed;
        // In words, where what a soil lacks is equal, too: as a number it is none, which equals nothing.
        let told = |case: Result<&ForcesCase, Vec<FieldFault>>| format!("{:?}", case.map(|case| (case.operation, case.slip)));
        assert_eq!(told(template.case(row)), told(long.case(row)), "{pointers:?} = {row:?} of {request}");
    }
    matches!(template.direct, Direct::Open(..))
}

fn letter() -> Value {
    json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02})
}

fn with(mut request: Value, changes: &[(&str, Value)]) -> Value {
    for (name, value) in changes {
        request[name] = value.clone();
    }
    request
}

#[test]
fn numbers_that_stand_for_themselves_are_set() {
    let firn = with(letter(), &[("soil", json!({"preset": "greenland-firn-lines-2021"}))]);
    let load = with(letter(), &[("sinkage_m", Value::Null), ("normal_load_n", json!(80))]);
    let from_static =
        with(letter(), &[("sinkage_m", Value::Null), ("static_sinkage_m", json!(0.01)), ("normal_load_n", json!(80))]);
    let rule = with(letter(), &[("contact", json!({"rule": "wong_reece", "c1": 0.4, "c2": 0.1}))]);
    // The last row is good again: a refused one leaves nothing behind.
    for (request, pointer, values) in [
        (letter(), "/wheel/radius_m", [0.3, 0.01, 200.0, 0.25]),
        (letter(), "/wheel/lug_height_m", [0.0, 0.01, -1.0, 0.02]),
        (letter(), "/soil/cohesion_pa", [0.0, 300.0, -1.0, 10.0]),
        (letter(), "/soil/friction_angle_rad", [0.4, 0.0, 1.6, 0.5]),
        (letter(), "/soil/shear_modulus_m", [0.01, 0.02, 0.0, 0.03]),
        (letter(), "/soil/pressure_sinkage/n0", [0.9, 1.2, -1.0, 1.0]),
        (letter(), "/soil/pressure_sinkage/k_c", [-660.0, 1e4, f64::NAN, 0.0]),
        (letter(), "/slip", [0.1, -1.0, 1.5, 1.0]),
        (letter(), "/sinkage_m", [0.01, 0.5, -1.0, 0.03]),
        (firn, "/soil/shear/residual_ratio", [0.5, 0.9, 2.0, 0.6]),
        (load, "/normal_load_n", [50.0, 1e3, -5.0, 80.0]),
        (from_static.clone(), "/static_sinkage_m", [0.01, 0.02, 1e9, 0.03]),
        (from_static, "/normal_load_n", [50.0, 1e3, -5.0, 80.0]),
        (rule.clone(), "/contact/c2", [0.2, 0.0, 1e9, 0.1]),
        (rule, "/contact/c3", [-0.1, 0.0, 1.0, -0.2]),
    ] {
        let rows = values.map(|value| [value]);
        let rows: Vec<&[f64]> = rows.iter().map(<[f64; 1]>::as_slice).collect();
        assert!(agree(&request, &[pointer], &rows), "{pointer}");
    }
    let many = ["/wheel/radius_m", "/soil/cohesion_pa", "/soil/pressure_sinkage/n0", "/slip", "/sinkage_m"];
    assert!(agree(&letter(), &many, &[&[0.2, 10.0, 0.9, 0.3, 0.5], &[0.2, 10.0, 0.9, 0.3, 0.01], &[0.6, 20.0, 1.1, -0.3, 0.5]]));
}

#[test]
fn numbers_on_which_others_depend_are_read() {
    let velocities = [("slip", Value::Null), ("forward_velocity_m_s", json!(0.1)), ("angular_velocity_rad_s", json!(1.0))];
    let moon = [("soil", json!({"preset": "letter-sand", "gravity_m_s2": 1.6}))];
    let grains = [("method", json!("resistive_force")), ("soil", json!({"friction_angle_rad": 0.5, "bulk_density_kg_m3": 1500}))];
    for (request, pointer) in [
        (with(letter(), &velocities), "/wheel/radius_m"),
        (with(letter(), &velocities), "/forward_velocity_m_s"),
        (with(letter(), &moon), "/soil/cohesion_pa"),
        (with(letter(), &grains), "/soil/friction_angle_rad"),
        (letter(), "/soil/gravity_m_s2"),
        (letter(), "/soil/unit_weight_n_m3"),
        (letter(), "/slip_angle_rad"),
        (letter(), "/lambda_a"),
    ] {
        assert!(!agree(&request, &[pointer], &[&[0.3], &[0.4], &[-9e9]]), "{pointer}");
    }
}

#[test]
fn a_mark_of_the_catalogue_stays() {
    let assumed = crate::catalogue::wheels().iter().find(|record| record.assumes("lug_height_m")).expect("such a wheel");
    let request = with(letter(), &[("wheel", json!({"preset": assumed.id, "width_m": 0.1, "radius_m": 0.2}))]);
    assert!(agree(&request, &["/wheel/width_m"], &[&[0.1], &[0.2]]));
    let fitted = with(
        letter(),
        &[("soil", json!({"preset": "soil-direct-90-smooth", "pressure_sinkage": {"k_s": 1e6}, "shear_modulus_m": 0.01}))],
    );
    assert!(agree(&fitted, &["/soil/cohesion_pa"], &[&[0.0], &[200.0]]));
}
