//! Answers with a status that refuses, and answers in JSON.

use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;

/// A request that is refused.
pub(crate) struct Refusal {
    pub(crate) status: StatusCode,
    message: String,
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        #[derive(Serialize)]
        struct Refused {
            message: String,
        }
        let mut response = json(&Refused { message: self.message });
        *response.status_mut() = self.status;
        response
    }
}

/// A request that is refused, with the sentence to show.
pub(crate) fn refused(status: StatusCode, message: &str) -> Refusal {
    Refusal { status, message: message.to_owned() }
}

pub(crate) fn json(value: &impl Serialize) -> Response {
    match serde_json::to_vec(value) {
        Ok(text) => ([(header::CONTENT_TYPE, "application/json")], text).into_response(),
        Err(error) => (StatusCode::INTERNAL_SERVER_ERROR, error.to_string()).into_response(),
    }
}

pub(crate) fn bad_request(message: &str) -> Refusal {
    refused(StatusCode::BAD_REQUEST, message)
}
