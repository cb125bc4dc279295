//! The pages of the four lab reports, looked at in a browser without a window: they load without errors, every figure is
//! there and inside its box, text is legible and lies on no other text, at the width of a phone and of a desk.
//!
//! The browser is Chromium, under one of its usual names or the one that `CHROMIUM` gives. Without one the test says so
//! loudly and passes, except where `CI` is set: there it fails.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

const NAMES: [&str; 5] =
    ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome-headless-shell"];

/// The widths at which pages are looked at, in pixels.
const WIDTHS: [u32; 2] = [390, 1280];

fn browser() -> Option<PathBuf> {
    let runs = |name: &Path| Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success());
    let wished = std::env::var_os("CHROMIUM").map(PathBuf::from);
    wished.into_iter().chain(NAMES.map(PathBuf::from)).find(|name| runs(name))
}

/// What a script inside each page measures: everything that is not as it should be, in words, and how much was looked at.
const MEASURE: &str = r#"
function measure(frame, width) {
  const doc = frame.contentDocument, wrong = [];
  const say = (words) => { if (wrong.length < 20) wrong.push(words); };
  const root = doc.documentElement;
  if (root.scrollWidth > width) say('the page is ' + root.scrollWidth + ' px wide');
  if (doc.compatMode !== 'CSS1Compat') say('quirks mode');
  const inside = (inner, outer, room) => inner.left >= outer.left - room && inner.right <= outer.right + room
    && inner.top >= outer.top - room && inner.bottom <= outer.bottom + room;
  let texts = 0, marks = 0;
  const drawings = [...doc.querySelectorAll('svg')];
  for (const svg of drawings) {
    const box = svg.getBoundingClientRect(), name = svg.getAttribute('aria-label');
    const figure = svg.closest('figure');
    if (!figure) { say(name + ': outside a figure'); continue; }
    if (box.width < 100 || box.height < 80) say(name + ': ' + box.width + ' × ' + box.height);
    if (!inside(box, figure.getBoundingClientRect(), 1)) say(name + ': leaves its figure');
    const shown = [];
    for (const text of svg.querySelectorAll('text')) {
      const own = text.getBoundingClientRect();
      texts += 1;
      if (!inside(own, box, 1)) say(name + ': "' + text.textContent + '" leaves the drawing');
      const size = parseFloat(getComputedStyle(text).fontSize) * box.width / svg.viewBox.baseVal.width;
      if (size < 8) say(name + ': "' + text.textContent + '" is ' + size.toFixed(1) + ' px high');
      for (const other of shown) {
        const across = Math.min(own.right, other.box.right) - Math.max(own.left, other.box.left);
        const down = Math.min(own.bottom, other.box.bottom) - Math.max(own.top, other.box.top);
        if (across > 2 && down > 4) say(name + ': "' + text.textContent + '" lies on "' + other.text + '"');
      }
      shown.push({ box: own, text: text.textContent });
    }
    for (const mark of svg.querySelectorAll('line,polyline,polygon,ellipse,rect')) {
      if (mark.closest('clipPath') || mark.closest('[clip-path]')) continue;
      marks += 1;
      if (!inside(mark.getBoundingClientRect(), box, 3)) say(name + ': a ' + mark.tagName + ' leaves the drawing');
    }
  }
  const ids = [...doc.querySelectorAll('[id]')].map((e) => e.id);
  for (const id of ids) if (ids.indexOf(id) !== ids.lastIndexOf(id)) say('two elements are named ' + id);
  for (const link of doc.querySelectorAll('nav a'))
    if (!doc.getElementById(link.getAttribute('href').slice(1))) say('no section ' + link.getAttribute('href'));
  for (const wide of doc.querySelectorAll('.wide'))
    if (wide.getBoundingClientRect().right > width + 1) say('a table or formula leaves the page');
  const formulas = [...doc.querySelectorAll('math')];
  for (const math of formulas) {
    if (math.namespaceURI !== 'http://www.w3.org/1998/Math/MathML') say('mathematics that is none');
    if (math.getBoundingClientRect().height < 5) say('an empty formula: ' + math.textContent);
  }
  return { wrong, figures: doc.querySelectorAll('figure').length, drawings: drawings.length, texts, marks,
           formulas: formulas.length };
}
"#;

/// A page that holds the one to be looked at in frames of each width, and in the end what was measured.
fn harness(page: &str) -> String {
    let text = serde_json::to_string(page).expect("text").replace("</", "<\\/").replace("<!--", "<\\u0021--");
    let widths = serde_json::to_string(&WIDTHS).expect("numbers");
    format!(
        "<!DOCTYPE html><html><body><script>{MEASURE}
const page = {text}, widths = {widths}, results = [], errors = [];
addEventListener('error', (e) => errors.push(e.message));
let waiting = widths.length;
for (const width of widths) {{
  const frame = document.createElement('iframe');
  frame.style.cssText = 'border:0;height:900px;width:' + width + 'px';
  frame.onload = () => {{
    results.push(Object.assign(measure(frame, width), {{ width }}));
    waiting -= 1;
    if (waiting === 0) {{
      const answer = JSON.stringify({{ errors, results }});
      document.body.innerHTML = '<pre id=\"answer\">' + btoa(unescape(encodeURIComponent(answer))) + '</pre>';
    }}
  }};
  frame.srcdoc = page;
  document.body.append(frame);
}}
</script></body></html>"
    )
}

/// What the browser prints of a page and says of its console.
fn opened(browser: &Path, folder: &Path, file: &Path) -> (String, String) {
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"])
        .args(["--enable-logging=stderr", "--virtual-time-budget=30000", "--dump-dom"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}", file.display()))
        .output()
        .expect("the browser runs");
    (
        String::from_utf8_lossy(&output.stdout).into_owned(),
        String::from_utf8_lossy(&output.stderr).into_owned(),
    )
}

/// Six bits a letter.
fn base64(text: &str) -> Vec<u8> {
    let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let values = text.bytes().filter_map(|b| letters.iter().position(|l| *l == b));
    let (mut bits, mut count, mut bytes) = (0u32, 0, Vec::new());
    for value in values {
        bits = bits << 6 | value as u32;
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count & 255) as u8);
        }
    }
    bytes
}

#[test]
fn figures_are_there_and_inside_their_boxes() {
    let Some(browser) = browser() else {
        let words = "NO BROWSER: the pages were not looked at. Install Chromium, or name it in CHROMIUM.";
        assert!(std::env::var_os("CI").is_none(), "{words}");
        eprintln!("\n{0}\n{words}\n{0}\n", "!".repeat(words.len()));
        return;
    };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("browser-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for the harness");
    let mut complaints = Vec::new();
    for report in report::pages::ALL {
        let page = (report.write)().unwrap_or_else(|error| panic!("{error}"));
        let file = folder.join(format!("{}.html", report.file));
        fs::write(&file, harness(&page.finish())).expect("the harness is written");
        let (printed, said) = opened(&browser, &folder, &file);
        let answer =
            printed.split_once("<pre id=\"answer\">").and_then(|(_, rest)| rest.split_once("</pre>"));
        let answer =
            answer.unwrap_or_else(|| panic!("{}: no answer\n{printed:.2000}\n{said}", report.file)).0;
        let answer: Value = serde_json::from_slice(&base64(answer)).expect("JSON");
        assert_eq!(answer["errors"], serde_json::json!([]), "{}", report.file);
        let console = said.lines().filter(|line| line.contains("CONSOLE"));
        complaints.extend(console.map(|line| format!("{}: {line}", report.file)));
        let results = answer["results"].as_array().expect("results");
        assert_eq!(results.len(), WIDTHS.len());
        for result in results {
            let count = |name: &str| result[name].as_u64().unwrap_or(0) as usize;
            println!("{}: {result}", report.file);
            assert_eq!(count("drawings"), page.drawings().len(), "{}", report.file);
            assert!(count("figures") >= 3 && count("texts") >= 20 && count("marks") > 100, "{result}");
            assert!(count("formulas") >= 12, "{result}");
            for wrong in result["wrong"].as_array().expect("complaints") {
                complaints.push(format!("{} at {} px: {wrong}", report.file, result["width"]));
            }
        }
    }
    let _ = fs::remove_dir_all(&folder);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}
