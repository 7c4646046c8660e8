//! `GET /v1/validation/{id}`: the columns under a load that is known beside the sinkage.

use serde_json::Value;

use crate::asking::{get, table};
use crate::validation::{numbers, predicted, set};

/// By hand: Ding's smooth wheel stands at 5 mm, and (18) gives 5·1.4/0.8 = 8.75 mm at a slip of 0.4.
#[test]
fn a_sinkage_from_the_standstill_follows_equation_18() {
    let set = set("ding-2011-smooth");
    let depths = predicted(&set, "linearised_known_load_from_standstill", "sinkage_m");
    assert_eq!(numbers(&set["columns"]["slip"])[4], Some(0.4));
    assert!((depths[4].expect("a sinkage") - 0.00875).abs() < 1e-15);
}

/// The columns are in the table of the set as well, and in the contract.
#[test]
fn the_columns_are_in_the_table_and_in_the_contract() {
    let columns = table(&get("/v1/validation/ding-2011-smooth?format=csv").text);
    assert!(columns.iter().any(|(name, _)| name == "predicted.quadrature_known_load.longitudinal_force_n"));
    let document: Value = serde_json::from_str(include_str!("../../openapi/openapi.json")).expect("JSON");
    let predicted = &document["components"]["schemas"]["PredictedColumns"]["properties"];
    for series in ["quadrature_known_load", "linearised_known_load", "linearised_known_load_from_standstill"] {
        assert!(predicted[series].is_object(), "{series}");
    }
}
