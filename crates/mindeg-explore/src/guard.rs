//! Who may ask: the page that this process opened, or a program that was given its token.
//!
//! A page of another origin can send requests to this machine but not set the header of the token, cannot
//! forge `Host`, `Origin` or `Sec-Fetch-Site`, and does not know the token.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use axum::http::{HeaderMap, HeaderName, Method, StatusCode, header};

use crate::token;

/// The header of the token.
pub(crate) const TOKEN: HeaderName = HeaderName::from_static("x-mindeg-token");

const FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");
const FETCH_MODE: HeaderName = HeaderName::from_static("sec-fetch-mode");

/// The rules that requests are checked against.
#[derive(Clone, Debug)]
pub(crate) struct Guard {
    pub(crate) port: u16,
    pub(crate) token: String,
}

/// Whether a request of a connection had the token.
#[derive(Clone, Debug, Default)]
pub(crate) struct HasToken(Arc<AtomicBool>);

impl HasToken {
    pub(crate) fn show(&self) {
        self.0.store(true, Relaxed);
    }

    pub(crate) fn is_shown(&self) -> bool {
        self.0.load(Relaxed)
    }
}

/// Why a request is refused, with a status.
pub(crate) type Refusal = (StatusCode, &'static str);

impl Guard {
    /// The names of this machine to itself.
    const HOSTS: [&'static str; 2] = ["127.0.0.1", "localhost"];

    /// Checks a request; `needs_token` for all but the page's own files.
    pub(crate) fn check(
        &self,
        method: &Method,
        headers: &HeaderMap,
        needs_token: bool,
    ) -> Result<(), Refusal> {
        let forbidden = |message| Err((StatusCode::FORBIDDEN, message));
        let Some(host) = only(headers, &header::HOST).filter(|host| self.is_ours(host)) else {
            return forbidden("this address is for the machine that mindeg explore runs on alone");
        };
        if headers.contains_key(header::ORIGIN) {
            let is_ours = only(headers, &header::ORIGIN)
                .and_then(|origin| origin.strip_prefix("http://"))
                .is_some_and(|origin| origin == host);
            if !is_ours {
                return forbidden(
                    "a page of another origin asked; only the page of mindeg explore may",
                );
            }
        }
        if headers.contains_key(FETCH_SITE) {
            let site = only(headers, &FETCH_SITE).unwrap_or_default();
            // Somebody may follow a link to the page; it can do nothing without the token.
            let opens_page = !needs_token && only(headers, &FETCH_MODE) == Some("navigate");
            if !matches!(site, "same-origin" | "none") && !opens_page {
                return forbidden("another site asked; only the page of mindeg explore may");
            }
        }
        if needs_token {
            let given = only(headers, &TOKEN).unwrap_or_default();
            if !token::is_same(given.as_bytes(), self.token.as_bytes()) {
                return forbidden(
                    "the token is missing or another run's; open the address that mindeg explore printed",
                );
            }
        } else if !matches!(*method, Method::GET | Method::HEAD) {
            return Err((StatusCode::METHOD_NOT_ALLOWED, "the page's files can only be read"));
        }
        Ok(())
    }

    fn is_ours(&self, host: &str) -> bool {
        let Some((name, port)) = host.rsplit_once(':') else { return false };
        Self::HOSTS.contains(&name) && port == self.port.to_string()
    }
}

/// The value of a header that occurs once.
fn only<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    let mut values = headers.get_all(name).iter();
    let value = values.next()?.to_str().ok()?;
    values.next().is_none().then_some(value)
}
