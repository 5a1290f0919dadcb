// How the report of a fit looks: CSS. It is inside of the page, and XML too, so it has neither '<' nor '&'.
#pragma once

#include <string_view>

namespace lapfx::match {

/// Blood and veil have the hues of a measurement's plot (match/video/plot.cpp). On a narrow screen a row of the table
/// becomes a card; paper is always light.
inline constexpr std::string_view report_style = R"css(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --ink: #1d2125; --quiet: #586069; --rule: #d5dade; --card: #f4f6f7; --gap: #e3e5e2;
  --blood: #be2828; --blood-band: #f2cdcd; --veil: #3c6996; --veil-band: #cddce8; --notice: #fff3d6;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #14171a; --ink: #e8eaec; --quiet: #a3abb3; --rule: #363c42; --card: #1d2226; --gap: #2a2e31;
    --blood: #ff7d70; --blood-band: #56292a; --veil: #7fb8ec; --veil-band: #24394d; --notice: #42351a;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; max-width: 64rem; padding: 1.5rem 1rem 3rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 Inter, system-ui, sans-serif; overflow-wrap: anywhere;
}
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0 0 1rem; }
h2 { font-size: 1.15rem; margin: 2.25rem 0 0.5rem; }
h3 { font-size: 1rem; margin: 1.25rem 0 0.4rem; }
p { margin: 0.4rem 0; }
code { font: 0.9em ui-monospace, "DejaVu Sans Mono", monospace; }
.closeness { background: var(--card); border-left: 0.3rem solid var(--veil); padding: 0.7rem 1rem; }
.closeness .main { font-size: 1.15rem; }
.notice { background: var(--notice); padding: 0.6rem 1rem; }
.quiet { color: var(--quiet); }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--quiet); padding-bottom: 0.3rem; }
th, td { text-align: left; vertical-align: top; padding: 0.45rem 0.9rem 0.45rem 0; border-bottom: 1px solid var(--rule); }
thead th { color: var(--quiet); font-weight: 500; border-bottom-width: 2px; }
tbody th { font-weight: 600; }
tbody th code { display: block; font-weight: 400; color: var(--quiet); white-space: nowrap; }
.value { white-space: nowrap; }
.narrow { width: auto; min-width: min(100%, 26rem); margin-top: 1rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 22rem), 1fr)); gap: 1.5rem; padding-top: 0.6rem; }
.plot { width: 100%; height: auto; max-width: 40rem; font: 14px Inter, system-ui, sans-serif; }
.plot text { fill: var(--ink); }
.plot .name { font-weight: 600; font-size: 15px; }
.plot .end { text-anchor: end; }
.plot .middle { text-anchor: middle; }
.plot .grid { stroke: var(--rule); }
.plot .axis { stroke: var(--quiet); }
.plot .gap { fill: var(--gap); }
.plot polyline, .plot line { fill: none; }
.plot .reference { stroke: var(--ink); stroke-width: 1.5; }
.plot .before { stroke: var(--quiet); stroke-width: 2; stroke-dasharray: 6 4; }
.plot .after { stroke-width: 3.5; stroke-linejoin: round; }
.plot .dot { fill: var(--ink); stroke-dasharray: none; }
.blood .band { fill: var(--blood-band); }
.blood .after { stroke: var(--blood); }
.veil .band { fill: var(--veil-band); }
.veil .after { stroke: var(--veil); }
.pictures { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 0.75rem; max-width: 61.5rem; }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; max-width: 320px; background: var(--card); }
figcaption { font-size: 0.9rem; line-height: 1.35; padding-top: 0.25rem; }
figcaption span { color: var(--quiet); white-space: nowrap; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.25rem 1.25rem; margin: 0.4rem 0; }
dt { color: var(--quiet); }
dd { margin: 0; }
ul { margin: 0.4rem 0; padding-left: 1.2rem; }
@media (max-width: 40rem) {
  .pictures { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .parameters thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  .parameters tr { display: block; padding: 0.5rem 0; border-bottom: 1px solid var(--rule); }
  .parameters th, .parameters td { display: block; border: 0; padding: 0.1rem 0; }
  .parameters td[data-label]::before { content: attr(data-label) ": "; color: var(--quiet); }
}
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  .plots { grid-template-columns: 1fr 1fr; }
  .pictures { grid-template-columns: repeat(3, minmax(0, 1fr)); }
  svg, figure, tr, .moment, .closeness { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .plot, .closeness, .notice { print-color-adjust: exact; }
}
)css";

}  // namespace lapfx::match
