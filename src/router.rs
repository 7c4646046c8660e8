//! The service put together: one function makes the router that the program serves and the tests call.

use std::sync::Arc;

use axum::Router;
use axum::http::Uri;
use axum::middleware;
use axum::response::{IntoResponse, Response};
use tower_http::catch_panic::CatchPanicLayer;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

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
use crate::api::{batch, catalogue, health, limits, model, sweep, track, validation};
use crate::contract::{self, Contract};
use crate::problem::Problem;
use crate::state::Service;
use crate::{docs, http1, observe, page};
use terramechanics_reading::shortened;

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
        .plain(routes!(health::healthz))
        .plain(routes!(health::readyz))
        .plain(routes!(health::metrics))
}

/// The operations and the contract that describes them and itself.
fn documented() -> (Router<Service>, Arc<Contract>) {
    let contract = Arc::default();
    let Operations { router, shown } = operations();
    let router = OpenApiRouter::with_openapi(contract::frame()).merge(router).merge(contract::route(&contract));
    let (routes, document) = router.split_for_parts();
    contract.describe(document, shown);
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
    if let Some(url) = service.public_url() {
        contract.served_at(url);
    }
    layered(routes.merge(page::routes()).merge(docs::routes()), contract, service)
}

/// `routes` with the fallbacks and layers of the service.
pub fn layered(routes: Router<Service>, contract: Arc<Contract>, service: Service) -> Router {
    let known = contract.clone();
    routes
        .fallback(|uri: Uri| async move { nothing_at(uri.path(), &known) })
        .method_not_allowed_fallback(|uri: Uri| async move { Problem::MethodNotAllowed(contract.methods_of(uri.path())) })
        .layer(CatchPanicLayer::custom(panicked))
        .layer(middleware::from_fn(http1::receive))
        .layer(middleware::from_fn_with_state(service.clone(), observe::observe))
        .with_state(service)
}

fn nothing_at(path: &str, contract: &Contract) -> Problem {
    let meant = contract.meant_by(path).map_or_else(String::new, |meant| format!("; did you mean {meant}?"));
    Problem::NotFound(format!("no such path: {}{meant}", shortened(path)))
}

fn panicked(cause: Box<dyn std::any::Any + Send>) -> Response {
    let text = cause.downcast_ref::<&str>().copied().or_else(|| cause.downcast_ref::<String>().map(String::as_str));
    tracing::error!(cause = text.unwrap_or("unknown"), "a request panicked");
    Problem::Internal.into_response()
}
