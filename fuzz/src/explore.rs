//! The page of `mindeg explore`: what it asks, and files that are dropped on it. The first byte tells which.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use mindeg_explore::{AnswerLine, KnownFiles, answer, sources};
use mindeg_files::{Input, Session};
use mindeg_mesh::{Progress, Step};

pub(crate) fn run(request: &[u8]) {
    let Some((&first, bytes)) = request.split_first() else { return };
    if first == b'f' {
        let Some(end) = bytes.iter().position(|&byte| byte == b'\n') else { return };
        let name = String::from_utf8_lossy(&bytes[..end]);
        match sources(&Session::new(""), &Input::Bytes(&name, &bytes[end + 1..]), None) {
            Ok(sources) => {
                assert!(sources.iter().all(|it| it.domain.is_some() != it.message.is_some()))
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
        return;
    }
    // A newer request ends the work on this one.
    let deadline = Instant::now() + Duration::from_millis(300);
    let newer = |_: Step<'_>| match Instant::now() > deadline {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    };
    let mut lines = 0;
    let mut count = |_: &AnswerLine| lines += 1;
    let done = answer(bytes, &KnownFiles::default(), Progress::new(&newer), &mut count);
    assert!(lines > 0 || done.is_err(), "a request without an answer");
}
