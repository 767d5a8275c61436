//! How long answers take, over a real socket: to the first mesh, to the mesh of the goal, to the curve and to the end,
//! while one request after the other comes as in a drag; and how long a newer request waits for an older one to
//! end. Under load, the processor time of the whole process tells more than the clock.
//!
//! `cargo bench -p mindeg-explore`

#![expect(clippy::unwrap_used, reason = "a benchmark fails by panicking")]

use std::io::{Read, Write};
use std::net::TcpStream;
use std::thread;
use std::time::{Duration, Instant};

use mindeg_explore::{Server, Setup, presets};
use serde_json::{Value, json};

/// How many times each is measured.
const TIMES: usize = 9;

struct Page {
    host: String,
    token: String,
}

impl Page {
    fn send(&self, tab: &str, body: &str) -> TcpStream {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        let Self { host, token } = self;
        let len = body.len();
        let request = format!(
            "POST /api/answer?tab={tab} HTTP/1.1\r\nHost: {host}\r\nX-Mindeg-Token: {token}\r\n\
             Connection: close\r\nContent-Length: {len}\r\n\r\n{body}"
        );
        stream.write_all(request.as_bytes()).unwrap();
        stream
    }
}

/// Milliseconds until each of the texts has come, infinite for those that never do.
fn times(stream: &mut TcpStream, start: Instant, texts: &[&str]) -> Vec<f64> {
    let mut found = vec![f64::INFINITY; texts.len()];
    let (mut all, mut some) = (Vec::new(), vec![0; 1 << 20]);
    let mut looked_at = 0;
    loop {
        let count = stream.read(&mut some).unwrap();
        let now = 1e3 * start.elapsed().as_secs_f64();
        all.extend_from_slice(&some[..count]);
        let text = String::from_utf8_lossy(&all[looked_at..]);
        for (found, wanted) in found.iter_mut().zip(texts) {
            if text.contains(wanted) {
                *found = found.min(now);
            }
        }
        // A text may be cut in two.
        looked_at = all.len().saturating_sub(64).max(looked_at);
        if count == 0 {
            return found;
        }
    }
}

/// Milliseconds of processor time that all threads of this process have taken; 0 where the system does not tell.
fn processor_time() -> f64 {
    /// The unit in which Linux counts processor time.
    const TICKS_A_SECOND: f64 = 100.0;
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after_name = stat.rsplit(')').next().unwrap_or_default();
    let ticks =
        after_name.split_whitespace().skip(11).take(2).filter_map(|n| n.parse::<f64>().ok());
    1e3 / TICKS_A_SECOND * ticks.sum::<f64>()
}

/// The median and the largest.
fn summary(mut values: Vec<f64>) -> String {
    values.sort_by(f64::total_cmp);
    format!("{:>8.1} {:>8.1}", values[values.len() / 2], values[values.len() - 1])
}

fn rectangle(count: u32, step: usize) -> Value {
    let [a, b] = [count * 3 / 10, count / 5];
    let sides = [a, b, a - 2, count - 2 * a - b + 2].map(|count| json!({"intervals": count}));
    json!({"rectangle": {"width": 4.0 + 0.01 * step as f64, "height": 3}, "sides": sides})
}

/// An L with its inner corner moved.
fn bracket(count: u32, step: usize) -> Value {
    let inner = 2.0 + 0.01 * step as f64;
    let corners = json!([[0, 0], [4, 0], [4, 2], [inner, 2], [2, 4], [0, 4]]);
    let sides = [25, 12, 15, 15, 10, 23].map(|share| json!({"intervals": share * count / 100}));
    json!({"polygon": {"corners": corners}, "sides": sides})
}

fn main() {
    let server = Server::new(Setup::default()).unwrap();
    let address = server.address();
    thread::spawn(move || server.run().map(|_| ()));
    let (host, token) = address.strip_prefix("http://").unwrap().split_once("/#").unwrap();
    let page = Page { host: host.to_owned(), token: token.to_owned() };
    let goal = json!({"keep_angle": 0.95});
    let texts = [
        "\"kind\":\"mesh\"",
        "\"view\":\"wanted\",\"is_last\":true",
        "\"kind\":\"curve\"",
        "\"kind\":\"done\"",
    ];
    let names = ["first mesh", "wanted mesh", "curve", "all"];
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    println!("milliseconds over a socket, {TIMES} times each: median and largest; load {load}");
    let names = names.map(|name| format!("{name:>18}")).concat();
    println!("{:<34}{names}  processor time", "");
    let channel = presets().into_iter().next().and_then(|preset| preset.domain).unwrap();
    let channel: Value = serde_json::from_str(channel.get()).unwrap();
    type Made = Box<dyn Fn(usize) -> Value>;
    let domains: [(&str, Made); 5] = [
        ("channel, 112 points", Box::new(move |_| channel.clone())),
        ("rectangle, 400 points", Box::new(|step| rectangle(400, step))),
        ("L, 400 points", Box::new(|step| bracket(400, step))),
        ("rectangle, 2000 points, no curve", Box::new(|step| rectangle(2000, step))),
        ("rectangle, 10,002 points, no curve", Box::new(|step| rectangle(10_002, step))),
    ];
    for (name, domain) in domains {
        let mut columns = vec![Vec::new(); texts.len()];
        let before = processor_time();
        for step in 0..TIMES {
            let mut request = json!({"domain": domain(step), "goal": goal, "color": "min_angle"});
            if name.contains("no curve") {
                request["show"] = json!(["wanted"]);
            }
            let body = request.to_string();
            let start = Instant::now();
            let mut stream = page.send("a", &body);
            for (column, time) in columns.iter_mut().zip(times(&mut stream, start, &texts)) {
                column.push(time);
            }
        }
        let columns = columns.into_iter().map(|column| format!(" {}", summary(column)));
        let each = (processor_time() - before) / TIMES as f64;
        println!("{name:<34}{} {each:>15.0}", columns.collect::<String>());
    }
    println!(
        "\nfrom a newer request of the tab to its first mesh, while the older one is worked on:"
    );
    for (name, count) in [("400 points", 400), ("4000 points", 4000)] {
        let mut waits = Vec::new();
        for step in 0..TIMES {
            let body = |step| json!({"domain": rectangle(count, step), "goal": goal}).to_string();
            let old = page.send("a", &body(step));
            // Somewhere in its work.
            thread::sleep(Duration::from_millis(5 + 23 * step as u64 % 120));
            let start = Instant::now();
            let mut stream = page.send("a", &body(step + 1));
            let mut some = [0; 4096];
            let mut text = String::new();
            while !text.contains(texts[0]) {
                let count = stream.read(&mut some).unwrap();
                text.push_str(&String::from_utf8_lossy(&some[..count]));
            }
            waits.push(1e3 * start.elapsed().as_secs_f64());
            drop((old, stream));
        }
        println!("{name:<34} {}", summary(waits));
    }
}
