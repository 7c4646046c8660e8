//! The operations of the API: each takes a checked request and returns an answer or a problem.

mod catalogue;
mod compare;
mod forces;
mod identify;
mod model;
mod operations;
mod responses;
mod slip_sweep;
mod stress_profile;

use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::app::Service;

/// All routes that the contract documents.
pub(crate) fn routes() -> OpenApiRouter<Service> {
    OpenApiRouter::new()
        .routes(routes!(forces::forces))
        .routes(routes!(stress_profile::stress_profile))
        .routes(routes!(slip_sweep::slip_sweep))
        .routes(routes!(compare::compare))
        .routes(routes!(identify::identify))
        .routes(routes!(identify::plates))
        .routes(routes!(identify::shear))
        .routes(routes!(catalogue::wheels))
        .routes(routes!(catalogue::wheel))
        .routes(routes!(catalogue::soils))
        .routes(routes!(catalogue::soil))
        .routes(routes!(model::model))
        .routes(routes!(operations::healthz))
        .routes(routes!(operations::readyz))
        .routes(routes!(operations::metrics))
        .routes(routes!(operations::openapi))
}
