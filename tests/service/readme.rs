//! What the README shows is what the service answers.

use serde_json::Value;

use crate::asking::{get, post, post_for_csv};

const README: &str = include_str!("../../README.md");

/// The contents of the README's code blocks in a language.
fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    README.split(opening.as_str()).skip(1).map(|rest| rest.split("```").next().expect("a block ends")).collect()
}

/// The body and the path of a curl command.
fn command(block: &str) -> (String, Value) {
    let path = block.split("127.0.0.1:8080").nth(1).and_then(|rest| rest.split(' ').next()).expect("a path");
    let body = block.split("-d '").nth(1).and_then(|rest| rest.split('\'').next()).expect("a body");
    (path.to_owned(), serde_json::from_str(body).expect("JSON"))
}

#[test]
fn the_first_request_has_the_answer_shown() {
    let (path, body) = command(blocks("sh")[0]);
    let shown: Value = serde_json::from_str(blocks("json")[0]).expect("JSON");
    let answer = post(&path, &body).ok();
    let close = |a: &Value, b: &Value| (a.as_f64().expect("a number") - b.as_f64().expect("a number")).abs() < 1e-9;
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "drawbar_coefficient", "tractive_efficiency"] {
        assert!(close(&shown[name], &answer[name]), "{name}");
    }
    assert_eq!(shown["warnings"], answer["warnings"]);
    let names = |value: &Value| value.as_object().expect("an object").keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&shown), names(&answer));
}

#[test]
fn the_explicit_figures_are_those_quoted() {
    let (path, mut body) = command(blocks("sh")[0]);
    body["method"] = "explicit".into();
    let answer = post(&path, &body).ok();
    let rounded = |name: &str, digits: usize| format!("{:.digits$}", answer[name].as_f64().expect("a number"));
    let quoted = [rounded("longitudinal_force_n", 1), rounded("normal_force_n", 1), rounded("torque_n_m", 2)];
    assert_eq!(quoted, ["12.1", "55.8", "4.72"]);
    assert!(README.contains("12.1 N, 55.8 N and 4.72 N·m"));
}

#[test]
fn the_sweep_is_a_table_of_101_rows() {
    let (path, body) = command(blocks("sh")[1]);
    assert_eq!(post_for_csv(&path, &body).text.lines().count(), 102);
}

#[test]
fn the_problem_shown_is_what_is_said() {
    let shown: Value = serde_json::from_str(blocks("json")[1]).expect("JSON");
    let (path, mut body) = command(blocks("sh")[0]);
    body["wheel"]["radus_m"] = 1.into();
    assert_eq!(post(&path, &body).problem(422)["errors"][0], shown);
}

#[test]
fn the_classical_estimates_are_those_quoted() {
    let example = serde_json::json!({
        "wheel": {"radius_m": 0.4065, "width_m": 0.229}, "normal_load_n": 259,
        "soil": {"preset": "lunar-apollo-nominal", "friction_angle_rad": 0.576, "unit_weight_n_m3": 2472}
    });
    let answer = post("/v1/resistances", &example).ok();
    let rounded = |name: &str, digits: usize| format!("{:.digits$}", answer[name].as_f64().expect("a number"));
    assert_eq!([rounded("compaction_resistance_n", 2), rounded("bulldozing_resistance_n", 1)], ["28.34", "90.4"]);
    assert!(README.contains("28.34 N of compaction and 90.4 N of bulldozing"));
}

#[test]
fn both_commands_are_named() {
    assert!(README.contains("cargo run --release") && README.contains("cargo test --workspace"));
}

#[test]
fn the_size_of_the_catalogue_is_the_one_stated() {
    let size = |path: &str, name: &str| get(path).ok()[name].as_array().expect("a list").len();
    let stated = format!("{} wheels and {} soils", size("/v1/wheels", "wheels"), size("/v1/soils", "soils"));
    assert!(README.contains(&stated), "{stated}");
}

/// Every set with its errors, rounded as shown; in brackets the points with a solution, where some have none.
#[test]
fn the_errors_against_measurements_are_those_of_the_service() {
    let rounded = |value: &Value, factor: f64, digits: usize| match value.as_f64() {
        Some(value) => format!("{:.digits$}", value * factor),
        None => "–".to_owned(),
    };
    let reply = get("/v1/validation").ok();
    let sets = reply["sets"].as_array().expect("sets");
    for set in sets {
        let id = set["id"].as_str().expect("an id");
        let results = set["results"].as_array().expect("results");
        let points = set["points"].as_u64().expect("points");
        let pull = results.iter().map(|result| {
            let error = rounded(&result["drawbar_rmse_over_load"], 1.0, 3);
            match result["unsolved"].as_u64() {
                Some(unsolved) if unsolved > 0 => format!("{error} ({})", points - unsolved),
                _ => error,
            }
        });
        let kind = if results[0]["fitted"] == true { "fitted" } else { "predicted" };
        let mut cells = vec![format!("`{id}`"), points.to_string(), kind.to_owned()];
        cells.extend(pull);
        cells.push(rounded(&results[0]["sinkage_rmse_m"], 1e3, 1));
        cells.push(rounded(&results[0]["torque_rmse_n_m"], 1.0, 2));
        let row = format!("| {} |", cells.join(" | "));
        assert!(README.lines().any(|line| line == row), "the README lacks: {row}");
    }
    assert_eq!(README.lines().filter(|line| line.contains("| predicted |") || line.contains("| fitted |")).count(), sets.len());
}
