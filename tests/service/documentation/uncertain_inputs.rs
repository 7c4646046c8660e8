//! `docs/validation.md`: what the pooled error would be with other values of inputs that nobody measured.

use serde_json::{Value, json};

use crate::asking::{get, post, with};

const TEXT: &str = include_str!("../../../docs/validation.md");

/// The sets of the 27 points; those of FJS-1 and KLS-1 stand after the first two.
const SETS: [&str; 5] =
    ["ding-2011-smooth", "ding-2011-lug10", "hurrell-2025-rashid", "wang-han-2016-smooth", "wang-han-2016-lug10"];

/// The squared errors of the pull over the load, point by point, with these changes of the soil.
fn squares(id: &str, soil: &Value) -> Vec<f64> {
    let set = get(&format!("/v1/validation/{id}")).ok();
    let column = |pointer: &str| -> Vec<f64> {
        let column = set.pointer(pointer).and_then(Value::as_array).expect("a column");
        column.iter().map(|value| value.as_f64().expect("a number")).collect()
    };
    let (slips, loads) = (column("/columns/slip"), column("/columns/normal_load_n"));
    let pulls = column("/columns/measured/longitudinal_force_n");
    let square = |row: usize| {
        let body = json!({
            "wheel": set["wheel"], "soil": set["soil"], "slip_radius": set["slip_radius"],
            "slip": slips[row], "normal_load_n": loads[row]
        });
        let found = post("/v1/forces", &with(&body, json!({"soil": soil}))).ok();
        ((found["longitudinal_force_n"].as_f64().expect("a pull") - pulls[row]) / loads[row]).powi(2)
    };
    (0..slips.len()).map(square).collect()
}

fn error(squares: &[f64]) -> String {
    format!("{:.3}", (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

fn of_sets(changed: &[&str], soil: &Value) -> Vec<f64> {
    let all = SETS.iter().flat_map(|id| if changed.contains(id) { squares(id, soil) } else { squares(id, &json!({})) });
    all.collect()
}

#[test]
fn the_errors_with_other_values_are_those_that_the_docs_quote() {
    let text = TEXT.split_whitespace().collect::<Vec<_>>().join(" ");
    let at = |modulus: f64| {
        let squares = of_sets(&SETS[2..], &json!({"shear_modulus_m": modulus}));
        assert_eq!(squares.len(), 27);
        error(&squares)
    };
    let said = format!(
        "With 20 mm on the three sets the 27 points err by {}, with 25 mm by {}, and with 15 mm by {}.",
        at(0.02),
        at(0.025),
        at(0.015)
    );
    assert!(text.contains(&said), "the text lacks: {said}");

    let halved = json!({"cohesion_pa": 1200});
    let own = get("/v1/validation/hurrell-2025-rashid").ok()["soil"]["cohesion_pa"].clone();
    assert_eq!(own, 2400);
    let said = format!(
        "With half of it the five points err by {} and the 27 by {}.",
        error(&squares(SETS[2], &halved)),
        error(&of_sets(&SETS[2..3], &halved))
    );
    assert!(text.contains(&said), "the text lacks: {said}");
}
