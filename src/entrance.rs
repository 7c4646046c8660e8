//! What every request passes on its way in and out: it is noted, what is ambiguous is refused, who has the answer already is told so, a
//! panic is answered like any failure of the service, and what is long is packed. One layer for all of it, because each costs a request
//! some allocations.

use std::any::Any;
use std::convert::Infallible;
use std::future::poll_fn;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::{Pin, pin};
use std::task::{Context, Poll};

use axum::extract::Request;
use axum::response::{IntoResponse, Response};

use crate::http1;
use crate::observe::Noted;
use crate::problem::Problem;
use crate::state::Service;

/// The layer.
#[derive(Clone)]
pub(crate) struct Entrance(pub(crate) Service);

/// What lies behind the entrance.
#[derive(Clone)]
pub(crate) struct Behind<S> {
    inner: S,
    service: Service,
}

impl<S> tower::Layer<S> for Entrance {
    type Service = Behind<S>;

    fn layer(&self, inner: S) -> Behind<S> {
        Behind { inner, service: self.0.clone() }
    }
}

impl<S> tower::Service<Request> for Behind<S>
where
    S: tower::Service<Request, Response = Response, Error = Infallible>,
    S::Future: Send + 'static,
{
    type Response = Response;
    type Error = Infallible;
    type Future = Pin<Box<dyn Future<Output = Result<Response, Infallible>> + Send>>;

    fn poll_ready(&mut self, context: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        self.inner.poll_ready(context)
    }

    fn call(&mut self, request: Request) -> Self::Future {
        let noted = Noted::of(&request, &self.service);
        let called = match http1::received(request) {
            Err(problem) => Err(problem.into_response()),
            Ok(request) => match noted.known(&request) {
                Some(known) => Err(known),
                None => catch_unwind(AssertUnwindSafe(|| self.inner.call(request))).map_err(|cause| panicked(&*cause)),
            },
        };
        let service = self.service.clone();
        Box::pin(async move {
            let response = match called {
                Ok(answer) => caught(answer).await,
                Err(response) => response,
            };
            Ok(noted.answered(response, &service))
        })
    }
}

/// The answer, also where it panics on the way.
async fn caught(answer: impl Future<Output = Result<Response, Infallible>>) -> Response {
    let mut answer = pin!(answer);
    poll_fn(|context| match catch_unwind(AssertUnwindSafe(|| answer.as_mut().poll(context))) {
        Ok(Poll::Pending) => Poll::Pending,
        Ok(Poll::Ready(Ok(response))) => Poll::Ready(response),
        Err(cause) => Poll::Ready(panicked(&*cause)),
    })
    .await
}

fn panicked(cause: &(dyn Any + Send)) -> Response {
    let text = cause.downcast_ref::<&str>().copied().or_else(|| cause.downcast_ref::<String>().map(String::as_str));
    tracing::error!(cause = text.unwrap_or("unknown"), "a request panicked");
    Problem::Internal.into_response()
}
