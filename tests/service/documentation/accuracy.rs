//! `docs/accuracy.md`: the figures and errata it quotes.

use super::{joined, table};
use crate::asking::{get, post};

const ACCURACY: &str = include_str!("../../../docs/accuracy.md");

#[test]
fn the_classical_estimates_are_those_quoted() {
    let example = serde_json::json!({
        "wheel": {"radius_m": 0.4065, "width_m": 0.229}, "normal_load_n": 259,
        "soil": {"preset": "lunar-apollo-nominal", "friction_angle_rad": 0.576, "unit_weight_n_m3": 2472}
    });
    let answer = post("/v1/resistances", &example).ok();
    let rounded = |name: &str, digits: usize| format!("{:.digits$}", answer[name].as_f64().expect("a number"));
    assert_eq!([rounded("compaction_resistance_n", 2), rounded("bulldozing_resistance_n", 1)], ["28.34", "90.4"]);
    assert!(joined(ACCURACY).contains("28.34 N of compaction and 90.4 N of bulldozing"));
}

/// Each row is an erratum of the model, at the same equation.
#[test]
fn the_errata_are_those_of_the_model() {
    let model = get("/v1/model").ok();
    let errata = model["errata"].as_array().expect("errata");
    assert!(joined(ACCURACY).contains(&format!("has all {} errata", errata.len())));
    let rows = table(ACCURACY, "## Errata in brief");
    assert!(!rows.is_empty());
    for row in rows {
        let erratum = errata.iter().find(|erratum| erratum["number"].as_u64() == row[0].parse().ok());
        let printed = erratum.and_then(|erratum| erratum["printed"].as_str()).unwrap_or_else(|| panic!("no erratum {}", row[0]));
        let equation = &row[1][..=row[1].find(')').expect("an equation")];
        assert!(printed.starts_with(equation), "erratum {} is about {printed}", row[0]);
    }
}
