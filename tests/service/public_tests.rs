//! The 27 points of the public single-wheel tests by a program that shares nothing with the model.

use serde_json::{Value, json};

use crate::asking::{get, post, with};

/// Written by `public_tests.py` beside it.
const BY_HAND: &str = include_str!("../../crates/terramechanics/tests/reference/public_tests.json");

/// What a solved sinkage is held to, and the pull that follows from it.
const SOLVED: f64 = 1e-9;

/// The ways that are those of a request, with their circles: of the slip, then of the displacement.
const WAYS: [(&str, &str, &str); 3] =
    [("slip_on_rim", "rim", "shearing"), ("slip_on_shearing_circle", "shearing", "shearing"), ("all_on_rim", "rim", "rim")];

fn sets() -> serde_json::Map<String, Value> {
    serde_json::from_str(BY_HAND).expect("JSON")
}

fn numbers(column: &Value) -> Vec<f64> {
    column.as_array().into_iter().flatten().map(|value| value.as_f64().expect("a number")).collect()
}

#[test]
fn sinkages_and_pulls_are_those_of_an_independent_integration() {
    let mut points = 0;
    for (id, by_hand) in sets() {
        let set = get(&format!("/v1/validation/{id}")).ok();
        let (slips, loads) = (numbers(&set["columns"]["slip"]), numbers(&set["columns"]["normal_load_n"]));
        for (way, slip, displacement) in WAYS {
            let of_way = &by_hand["ways"][way];
            let (sinkages, pulls) = (numbers(&of_way["sinkage_m"]), numbers(&of_way["longitudinal_force_n"]));
            assert_eq!((slips.len(), sinkages.len(), pulls.len()), (sinkages.len(), pulls.len(), loads.len()), "{id}");
            for row in 0..slips.len() {
                let body = json!({"wheel": set["wheel"], "soil": set["soil"], "slip": slips[row], "normal_load_n": loads[row]});
                let circles = json!({"slip_radius": slip, "shear_displacement_radius": displacement});
                let found = post("/v1/forces", &with(&body, circles)).ok();
                let found = ["sinkage_m", "longitudinal_force_n"].map(|name| found[name].as_f64().expect("a number"));
                assert!((found[0] / sinkages[row] - 1.0).abs() <= SOLVED, "{id} {way} {row}: {found:?}");
                // The pull is a difference of parts as large as the load.
                assert!((found[1] - pulls[row]).abs() <= SOLVED * loads[row], "{id} {way} {row}: {found:?}");
                points += 1;
            }
        }
    }
    assert_eq!(points, 27 * WAYS.len());
}

/// The errors of a displacement from where the rim enters, which no request can choose.
#[test]
fn the_errors_from_the_entry_of_the_rim_are_those_that_the_docs_quote() {
    let sets = sets();
    let error = |id: &str, way: &str| sets[id]["ways"][way]["drawbar_rmse_over_load"].as_f64().expect("an error");
    let over_all = |way: &str| {
        let points = |id: &str| sets[id]["points"].as_f64().expect("points");
        let squares: f64 = sets.keys().map(|id| error(id, way).powi(2) * points(id)).sum();
        (squares / sets.keys().map(|id| points(id)).sum::<f64>()).sqrt()
    };
    let [ding, rashid, kls] =
        ["ding-2011-lug10", "hurrell-2025-rashid", "wang-han-2016-lug10"].map(|id| error(id, "entry_of_rim"));
    let text = include_str!("../../docs/validation.md").split_whitespace().collect::<Vec<_>>().join(" ");
    for said in [
        format!("would the slip on the rim err by {ding:.3}, {rashid:.3} and {kls:.3} on the three wheels with lugs"),
        format!("and by {:.3} over all 27", over_all("entry_of_rim")),
        format!("with the slip on the shearing circle it errs by {:.3}", over_all("entry_of_rim_slip_on_shearing_circle")),
    ] {
        assert!(text.contains(&said), "the text lacks: {said}");
    }
}
