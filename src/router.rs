//! The service put together: one function makes the router that the program serves and the tests call.

use std::sync::Arc;

use axum::Router;
use axum::http::Uri;
use axum::middleware;
use axum::response::{IntoResponse, Response};
use tower_http::catch_panic::CatchPanicLayer;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::api::{
    catalogue, compare, coupled, forces, health, identify, limits, model, resistances, slip_sweep, stress_profile, towed, track,
    validation,
};
use crate::contract::{self, Contract};
use crate::problem::Problem;
use crate::state::Service;
use crate::{docs, http1, observe, page};
use terramechanics_reading::shortened;

/// The operations of the contract, in its order.
fn operations() -> OpenApiRouter<Service> {
    OpenApiRouter::new()
        .routes(routes!(forces::forces, forces::forces_of_query))
        .routes(routes!(stress_profile::stress_profile, stress_profile::stress_profile_of_query))
        .routes(routes!(slip_sweep::slip_sweep, slip_sweep::slip_sweep_of_query))
        .routes(routes!(compare::compare))
        .routes(routes!(coupled::coupled))
        .routes(routes!(resistances::resistances, resistances::resistances_of_query))
        .routes(routes!(towed::towed))
        .routes(routes!(identify::identify))
        .routes(routes!(identify::plates))
        .routes(routes!(identify::shear))
        .routes(routes!(track::track))
        .routes(routes!(catalogue::wheels))
        .routes(routes!(catalogue::wheel))
        .routes(routes!(catalogue::soils))
        .routes(routes!(catalogue::soil))
        .routes(routes!(validation::validation))
        .routes(routes!(validation::validation_set))
        .routes(routes!(model::model))
        .routes(routes!(limits::limits))
        .routes(routes!(health::healthz))
        .routes(routes!(health::readyz))
        .routes(routes!(health::metrics))
}

/// The operations and the contract that describes them and itself.
fn documented() -> (Router<Service>, Arc<Contract>) {
    let contract = Arc::default();
    let router = OpenApiRouter::with_openapi(contract::frame()).merge(operations()).merge(contract::route(&contract));
    let (routes, document) = router.split_for_parts();
    contract.describe(document);
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
