//! `docs/clients.md`: the programs, the table and the failure it shows.

use serde_json::Value;

use super::blocks;
use super::readme::{command, first_request};
use crate::asking::{post, post_for_csv};

const TEXT: &str = include_str!("../../../docs/clients.md");

/// Each with the block that shows its request, by language and place among the blocks of that language.
const CLIENTS: [(&str, &str, usize); 9] = [
    (include_str!("../../../clients/curve_pandas.py"), "python", 0),
    (include_str!("../../../clients/forces_requests.py"), "python", 1),
    (include_str!("../../../clients/generated_client.py"), "python", 2),
    (include_str!("../../../clients/curve.m"), "matlab", 0),
    (include_str!("../../../clients/forces.mjs"), "js", 0),
    (include_str!("../../../clients/curve.sh"), "sh", 1),
    (include_str!("../../../clients/pydantic_models.py"), "python", 3),
    (include_str!("../../../clients/fetch.mjs"), "js", 1),
    (include_str!("../../../clients/batch.py"), "python", 4),
];

#[test]
fn what_is_shown_of_a_client_stands_in_its_program() {
    for (program, language, place) in CLIENTS {
        let block = blocks(TEXT, language)[place];
        assert!(!block.is_empty() && program.contains(&format!("\n{block}")), "no program has: {block}");
    }
    for language in ["python", "matlab", "js"] {
        let shown = CLIENTS.iter().filter(|client| client.1 == language).count();
        assert_eq!(blocks(TEXT, language).len(), shown, "{language}");
    }
}

#[test]
fn the_commands_that_generate_a_client_are_those_of_its_program() {
    for (program, command) in [
        (CLIENTS[2].0, "openapi-python-client generate --meta none --url http://127.0.0.1:8080/openapi.json"),
        (
            CLIENTS[4].0,
            "openapi-typescript http://127.0.0.1:8080/openapi.json --default-non-nullable=false --output terramechanics.d.ts",
        ),
        (
            CLIENTS[6].0,
            "datamodel-codegen --allow-private-network --url http://127.0.0.1:8080/openapi.json --output terramechanics_models.py",
        ),
    ] {
        assert!(TEXT.contains(&format!("`{command}`")) && program.contains(command), "{command}");
    }
}

#[test]
fn the_sweep_is_a_table_of_101_rows() {
    let (path, body) = command(blocks(TEXT, "sh")[0]);
    assert_eq!(post_for_csv(&path, &body).text.lines().count(), 102);
}

#[test]
fn a_known_load_and_a_torque_have_answers() {
    let shown = blocks(TEXT, "sh");
    let answers = [3, 4].map(|place| {
        let (path, body) = command(shown[place]);
        (path.clone(), post(&path, &body).ok())
    });
    assert_eq!((answers[0].0.as_str(), answers[1].0.as_str()), ("/v1/forces", "/v1/coupled"));
    assert!(answers[0].1["sinkage_modulus"].as_f64().is_some_and(|modulus| modulus > 0.0));
    assert!(answers[1].1["longitudinal_force_n"].is_number());
}

#[test]
fn the_problem_shown_is_what_is_said() {
    let shown: Value = serde_json::from_str(blocks(TEXT, "json")[0]).expect("JSON");
    let (path, mut body) = first_request();
    body["wheel"]["radus_m"] = 1.into();
    assert_eq!(post(&path, &body).problem(422)["errors"][0], shown);
}
