//! `docs/validation.md`: its tables and the figures in its text.

use serde_json::Value;

use super::joined;
use crate::asking::get;

const TEXT: &str = include_str!("../../../docs/validation.md");

fn sets() -> Vec<Value> {
    get("/v1/validation").ok()["sets"].as_array().expect("sets").clone()
}

fn rounded(value: &Value, factor: f64, digits: usize) -> String {
    value.as_f64().map_or_else(|| "–".to_owned(), |value| format!("{:.digits$}", value * factor))
}

/// An error over the load; in brackets the points with a solution, where some have none.
fn over_load(result: &Value, error: &str) -> String {
    let error = rounded(&result[error], 1.0, 3);
    if result["unsolved"] == 0 { error } else { format!("{error} ({})", result["solved"]) }
}

fn assert_row(cells: &[String]) {
    let row = format!("| {} |", cells.join(" | "));
    assert!(TEXT.lines().any(|line| line == row), "the text lacks: {row}");
}

/// Every set with its errors, rounded as shown.
#[test]
fn the_errors_against_measurements_are_those_of_the_service() {
    let sets = sets();
    for set in &sets {
        let results = set["results"].as_array().expect("results");
        let kind = if results[0]["fitted"] == true { "fitted" } else { "predicted" };
        let mut cells = vec![format!("`{}`", set["id"].as_str().expect("an id")), set["points"].to_string(), kind.to_owned()];
        if set["slip_angle_rad"].is_number() {
            cells.extend(results.iter().map(|result| over_load(result, "lateral_rmse_over_load")));
            cells.extend([0, 2].map(|i| over_load(&results[i], "drawbar_rmse_over_load")));
        } else {
            cells.extend(results.iter().take(3).map(|result| over_load(result, "drawbar_rmse_over_load")));
            cells.push(rounded(&results[0]["sinkage_rmse_m"], 1e3, 1));
            cells.push(rounded(&results[0]["torque_rmse_n_m"], 1.0, 2));
        }
        assert_row(&cells);
    }
    assert_eq!(TEXT.lines().filter(|line| line.contains("| predicted |") || line.contains("| fitted |")).count(), sets.len());
}

/// Both laws of braking, each error as shown, and over the rows that both solve, recomputed here.
#[test]
fn the_errors_of_both_laws_of_braking_are_those_of_the_service() {
    let mut braking = 0;
    for set in sets() {
        let results = set["results"].as_array().expect("results");
        let Some(two) = results.iter().find(|result| result["braking"] == "two_zone") else { continue };
        let mut cells = vec![format!("`{}`", set["id"].as_str().expect("an id"))];
        cells.extend([&results[0], two].map(|result| over_load(result, "drawbar_rmse_over_load")));
        cells.extend([&results[0], two].map(|result| rounded(&result["sinkage_rmse_m"], 1e3, 1)));
        assert_row(&cells);
        braking += 1;
        if set["id"] == "cmu-grousered-braking" {
            let errors = common_errors(std::slice::from_ref(&set), &["quadrature", "quadrature_two_zone"], "drawbar_coefficient");
            assert_eq!(errors.map(|(error, points)| (format!("{error:.3}"), points)), Some(("0.106".to_owned(), 3)));
        }
    }
    assert_eq!(braking, 2);
    assert!(joined(TEXT).contains("one zone also errs by 0.106"));
}

/// The method of dry grains, with the density that each set takes.
#[test]
fn the_errors_in_grains_are_those_of_the_service() {
    let mut rows = 0;
    for set in sets() {
        let results = set["results"].as_array().expect("results");
        let Some(grains) = results.iter().find(|result| result["method"] == "resistive_force") else { continue };
        let density = match set["soil"]["preset"].as_str() {
            Some(preset) => get(&format!("/v1/soils/{preset}")).ok()["soil"]["bulk_density_kg_m3"].clone(),
            None => set["soil"]["bulk_density_kg_m3"].clone(),
        };
        let inputs = set["inputs"].as_array().expect("inputs");
        let named = inputs.iter().find(|input| input["name"] == "soil.bulk_density_kg_m3").expect("a source of the density");
        assert_eq!(named["value"].as_f64(), density.as_f64(), "{}", set["id"]);
        let mut cells = vec![format!("`{}`", set["id"].as_str().expect("an id")), rounded(&density, 1.0, 0)];
        cells.extend([&results[0], grains].map(|result| over_load(result, "drawbar_rmse_over_load")));
        cells.extend([&results[0], grains].map(|result| rounded(&result["sinkage_rmse_m"], 1e3, 1)));
        cells.extend([&results[0], grains].map(|result| rounded(&result["torque_rmse_n_m"], 1.0, 2)));
        assert_row(&cells);
        rows += 1;
    }
    assert_eq!(rows, 10);
    let tested = ["ding-2011-smooth", "ding-2011-lug10", "hurrell-2025-rashid", "wang-han-2016-smooth", "wang-han-2016-lug10"];
    let tested: Vec<Value> = sets().into_iter().filter(|set| tested.iter().any(|id| set["id"] == *id)).collect();
    let pooled = ["resistive_force", "quadrature"].map(|series| common_errors(&tested, &[series], "drawbar_coefficient"));
    let words = pooled.map(|pooled| pooled.map(|(error, points)| (format!("{error:.3}"), points)).expect("points"));
    let said = format!(
        "over the {} points of the first five sets it errs by {}, the quadrature by {}",
        words[0].1, words[0].0, words[1].0
    );
    assert!(joined(TEXT).contains(&said), "the text lacks: {said}");
    let methods = get("/v1/model").ok()["methods"].as_array().expect("methods").clone();
    let note = methods.into_iter().find(|method| method["method"] == "resistive_force").expect("the method");
    let said = format!(
        "over {} points of five public sets the pull errs by {} of the load (quadrature {})",
        words[0].1, words[0].0, words[1].0
    );
    assert!(note["accuracy"].as_str().is_some_and(|accuracy| accuracy.contains(&said)), "the model lacks: {said}");
}

/// The error of the first series over the points that all of them solve, and their number.
fn common_errors(sets: &[Value], series: &[&str], name: &str) -> Option<(f64, usize)> {
    let mut squares = Vec::new();
    for set in sets {
        let columns = &set["columns"];
        for row in 0..columns["slip"].as_array()?.len() {
            let all: Option<Vec<f64>> = series.iter().map(|series| columns["predicted"][series][name][row].as_f64()).collect();
            squares.extend(all.map(|all| (all[0] - columns["measured"][name][row].as_f64().unwrap_or(f64::NAN)).powi(2)));
        }
    }
    let count = squares.len();
    (count > 0).then(|| ((squares.iter().sum::<f64>() / count as f64).sqrt(), count))
}

/// The errors of the lateral force over all slip angles, from the columns.
#[test]
fn the_pooled_errors_of_the_side_force_are_those_of_the_columns() {
    const SERIES: [&str; 4] = ["quadrature", "quadrature_mobilised", "quadrature_coupled", "quadrature_coupled_mobilised"];
    let of = |wheel: &str| -> Vec<Value> {
        let prefix = format!("cmu-{wheel}-side-");
        sets().into_iter().filter(|set| set["id"].as_str().is_some_and(|id| id.starts_with(&prefix))).collect()
    };
    let text = joined(TEXT);
    let pooled = |sets: &[Value], beside: &[&str]| {
        let errors = SERIES.map(|series| {
            let together: Vec<&str> = [series].into_iter().chain(beside.iter().copied()).collect();
            common_errors(sets, &together, "lateral_coefficient").expect("points")
        });
        let words = errors.map(|(error, _)| format!("{error:.3}"));
        (format!("{}, {}, {} and {}", words[0], words[1], words[2], words[3]), errors.map(|(_, count)| count))
    };
    let (grousered, smooth) = (of("grousered"), of("smooth"));
    for (sets, beside, counts) in [(&grousered, &[][..], [24; 4]), (&smooth, &[], [24, 24, 22, 22]), (&smooth, &SERIES, [22; 4])]
    {
        let (words, found) = pooled(sets, beside);
        assert!(text.contains(&words), "the text lacks: {words}");
        assert_eq!(found, counts);
    }
    assert!(joined(include_str!("../../../docs/accuracy.md")).contains("it errs by 0.34 and 0.27 of the load"));
    for (sets, driving, braking) in [(&grousered, "0.07", "0.28"), (&smooth, "0.04", "0.19")] {
        for (series, drives, quoted) in [(SERIES[1], true, driving), (SERIES[3], true, driving), (SERIES[3], false, braking)] {
            let parts: Vec<Value> = sets.iter().map(|set| only(set, |slip| (slip >= 0.0) == drives)).collect();
            let (error, _) = common_errors(&parts, &[series], "lateral_coefficient").expect("points");
            assert_eq!(format!("{error:.2}"), quoted, "{series}");
        }
    }
    assert!(text.contains("down to 0.07 (grousered) and 0.04 (smooth)") && text.contains("the last pair least: 0.28 and 0.19"));
}

/// The set with its predictions at other slips struck out.
fn only(set: &Value, is_meant: impl Fn(f64) -> bool) -> Value {
    let mut set = set.clone();
    let slips: Vec<f64> = set["columns"]["slip"].as_array().expect("slips").iter().filter_map(Value::as_f64).collect();
    for forces in set["columns"]["predicted"].as_object_mut().expect("series").values_mut() {
        for (row, _) in slips.iter().enumerate().filter(|(_, slip)| !is_meant(**slip)) {
            forces["lateral_coefficient"][row] = Value::Null;
        }
    }
    set
}
