//! The service put together: one function makes the router that the program serves and the tests call.

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::http::header::{ACCEPT, CONTENT_ENCODING, CONTENT_TYPE, ETAG, IF_NONE_MATCH, RETRY_AFTER};
use axum::http::{HeaderValue, Method, StatusCode, Uri};
use axum::response::IntoResponse;
use tower_http::cors::{AllowOrigin, CorsLayer};
use utoipa::openapi::OpenApi as Document;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::answer::WARNINGS;
use crate::api::compare::{self, CompareCase};
use crate::api::coupled::{self, CoupledCase};
use crate::api::curves::plates::{self, PlatesCase};
use crate::api::curves::shear::{self, ShearTestsCase};
use crate::api::forces::{self, ForcesCase};
use crate::api::identify::{self, IdentifyCase};
use crate::api::operations::Operations;
use crate::api::optimum::{self, OptimumCase};
use crate::api::resistances::{self, ResistancesCase};
use crate::api::slip_sweep::{self, SweepCase};
use crate::api::stress_profile::{self, ProfileCase};
use crate::api::towed::{self, TowedCase};
use crate::api::uncertainty::{self, UncertaintyCase};
use crate::api::vehicle::{self, VehicleCase};
use crate::api::{batch, catalogue, health, limits, model, problems, sweep, track, validation};
use crate::contract::{self, Contract, Shown};
use crate::entrance::Entrance;
use crate::observe::{CATALOGUE_VERSION, MODEL_VERSION, REQUEST_ID};
use crate::problem::Problem;
use crate::state::Service;
use crate::{docs, page};
use terramechanics_reading::shortened;

/// How long a browser keeps what it was told before it asked; none keeps it longer.
const PREFLIGHT: Duration = Duration::from_secs(7200);

/// The operations of the contract, in its order: a row for each.
fn operations() -> Operations {
    Operations::new()
        .room::<ForcesCase>(routes!(forces::forces, forces::forces_of_query))
        .room::<ProfileCase>(routes!(stress_profile::stress_profile, stress_profile::stress_profile_of_query))
        .room::<SweepCase>(routes!(slip_sweep::slip_sweep, slip_sweep::slip_sweep_of_query))
        .shown(routes!(sweep::sweep), sweep::example)
        .room::<UncertaintyCase>(routes!(uncertainty::uncertainty))
        .room::<OptimumCase>(routes!(optimum::optimum))
        .room::<CompareCase>(routes!(compare::compare))
        .room::<CoupledCase>(routes!(coupled::coupled))
        .room::<ResistancesCase>(routes!(resistances::resistances, resistances::resistances_of_query))
        .room::<TowedCase>(routes!(towed::towed))
        .room::<VehicleCase>(routes!(vehicle::vehicle, vehicle::vehicle_of_query))
        .room::<IdentifyCase>(routes!(identify::identify))
        .room::<PlatesCase>(routes!(plates::plates))
        .room::<ShearTestsCase>(routes!(shear::shear))
        .shown(routes!(track::track), track::example)
        .shown(routes!(batch::batch), batch::example)
        .shown(routes!(catalogue::wheels), catalogue::example_of_wheels)
        .shown(routes!(catalogue::wheel), catalogue::example_of_wheel)
        .shown(routes!(catalogue::soils), catalogue::example_of_soils)
        .shown(routes!(catalogue::soil), catalogue::example_of_soil)
        .shown(routes!(validation::validation), validation::example)
        .shown(routes!(validation::validation_set), validation::example_of_set)
        .plain(routes!(model::model))
        .plain(routes!(limits::limits))
        .plain(routes!(problems::problems))
        .plain(routes!(problems::problem))
        .plain(routes!(health::healthz))
        .plain(routes!(health::readyz))
        .plain(routes!(health::metrics))
}

/// The operations with the document that describes them, and what it shows of them.
fn described(contract: &Arc<Contract>) -> (Router<Service>, Document, Vec<Shown>) {
    let Operations { router, shown } = operations();
    let router = OpenApiRouter::with_openapi(contract::frame()).merge(router).merge(contract::route(contract));
    let (routes, document) = router.split_for_parts();
    (routes, document, shown)
}

/// The operations and the contract that describes them and itself.
fn documented() -> (Router<Service>, Arc<Contract>) {
    let contract = Arc::default();
    let (routes, document, _) = described(&contract);
    contract.describe(&document, || {
        let (_, document, shown) = described(&Arc::default());
        (document, shown)
    });
    (routes, contract)
}

/// The contract of the service.
#[must_use]
pub fn contract() -> Arc<Contract> {
    documented().1
}

/// The router of the service, with every layer on.
pub fn app(service: Service) -> Router {
    let (routes, contract) = documented();
    if let Some(url) = &service.outside().public_url {
        contract.served_at(url);
    }
    layered(routes.merge(page::routes()).merge(docs::routes()), contract, service)
}

/// `routes` with the fallbacks and the entrance of the service.
pub fn layered(routes: Router<Service>, contract: Arc<Contract>, service: Service) -> Router {
    let known = contract.clone();
    let routes = routes.fallback(|uri: Uri| async move { nothing_at(uri.path(), &known) }).method_not_allowed_fallback(
        |method: Method, uri: Uri| async move {
            // The router adds the header Allow.
            if method == Method::OPTIONS {
                return StatusCode::NO_CONTENT.into_response();
            }
            Problem::MethodNotAllowed(contract.methods_of(uri.path())).into_response()
        },
    );
    let routes = match shared(&service.outside().origins) {
        Some(shared) => routes.layer(shared),
        None => routes,
    };
    routes.layer(Entrance(service.clone())).with_state(service)
}

/// What lets pages of these origins ask the service and read its answers (CORS); without one, browsers keep them from it.
fn shared(origins: &[HeaderValue]) -> Option<CorsLayer> {
    if origins.is_empty() {
        return None;
    }
    let any = HeaderValue::from_static("*");
    let allowed = if origins.contains(&any) { AllowOrigin::any() } else { AllowOrigin::list(origins.iter().cloned()) };
    let layer = CorsLayer::new()
        .allow_origin(allowed)
        .allow_methods([Method::GET, Method::POST])
        .allow_headers([ACCEPT, CONTENT_TYPE, CONTENT_ENCODING, IF_NONE_MATCH, REQUEST_ID])
        .expose_headers([ETAG, RETRY_AFTER, REQUEST_ID, MODEL_VERSION, CATALOGUE_VERSION, WARNINGS])
        .max_age(PREFLIGHT);
    Some(layer)
}

fn nothing_at(path: &str, contract: &Contract) -> Problem {
    let meant = contract.meant_by(path).map_or_else(String::new, |meant| format!("; did you mean {meant}?"));
    Problem::NotFound(format!("no such path: {}{meant}", shortened(path)))
}
