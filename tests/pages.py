"""Opens every page in a folder in headless Chromium, and uses it as a person would.

    pages.py CHROMIUM FOLDER [NAME …]: the pages that must be there; all unless told.
"""

import os
import sys
import xml.etree.ElementTree
from pathlib import Path

from axe_core_python.sync_playwright import Axe
from playwright.sync_api import sync_playwright

ARGUMENTS = [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
]
# Every page, and how many charts it has at least.
CHARTS = {
    "run": 30, "dense": 20, "perfect": 20, "replay": 18, "ensemble": 20, "allan": 2, "frontier": 2, "hil": 30, "stream": 25,
    "aided": 20, "smoothed": 30, "stress": 0, "verify": 0, "compare": 0, "sensitivity": 0,
}
# Pages of the form of another one, which is looked at in every light.
ALIKE = {"dense", "perfect", "stream", "smoothed"}
faults = []


def fault(page, what):
    faults.append(f"{page}: {what}")


def colours(page, index):
    """Pixels of a chart's canvas that are neither clear nor grey, as far as 20: what its layers have drawn."""
    return page.evaluate(
        """index => {
          const { ctx, bbox } = plots[index].u;
          const copy = new OffscreenCanvas(bbox.width, bbox.height).getContext("2d", { willReadFrequently: true });
          copy.drawImage(ctx.canvas, -bbox.left, -bbox.top);
          const { data } = copy.getImageData(0, 0, bbox.width, bbox.height);
          let count = 0;
          for (let i = 0; i < data.length && count < 20; i += 4) {
            const [r, g, b, a] = [data[i], data[i + 1], data[i + 2], data[i + 3]];
            if (a > 60 && (Math.max(r, g, b) - Math.min(r, g, b) > 24 || Math.max(r, g, b) < 60)) count++;
          }
          return count;
        }""",
        index,
    )


def scale(page, index, side="x"):
    return page.evaluate("([i, side]) => { const { min, max } = plots[i].u.scales[side]; return [min, max]; }", [index, side])


def drawn(name, page):
    figures = page.locator("figure.plot").count()
    if figures < CHARTS[name]:
        fault(name, f"has {figures} charts of {CHARTS[name]}")
    for index in range(figures):
        title = page.evaluate("i => plots[i]?.spec.title", index)
        if title is None:
            fault(name, f"chart {index} is not drawn")
        elif colours(page, index) < 20:
            fault(name, f"{title}: nothing is in it")


def used(name, page):
    """Cursor, zoom, whole, legend, files."""
    if page.locator("figure.plot").count() == 0:
        return
    over = page.locator(".u-over").first
    over.scroll_into_view_if_needed()
    box = over.bounding_box()

    def at(part, height=0.5):
        return box["x"] + part * box["width"], box["y"] + height * box["height"]

    is_map = page.evaluate("plots[0].spec.map || !!plots[0].spec.near")
    shares = page.evaluate("plots.filter(plot => plot.spec.cursor && plot.spec.cursor === plots[0].spec.cursor).length")
    if not is_map:
        page.mouse.move(*at(0.6))
        page.wait_for_timeout(100)
        told = page.evaluate("[...document.querySelectorAll('.values:not([hidden])')].map(e => e.textContent)")
        unit = page.evaluate("plots[0].spec.y.unit")
        if not told or (unit and unit not in told[0]):
            fault(name, f"the cursor tells {told[:1]} without {unit}")
        if shares > 1 and len(told) < shares:
            fault(name, f"{shares} charts share a cursor, {len(told)} tell values")
    whole = scale(page, 0)
    if None in whole:
        return fault(name, "the first chart has no scale")
    page.mouse.move(*at(0.3, 0.3))
    page.mouse.down()
    page.mouse.move(*at(0.45, 0.6))
    page.mouse.move(*at(0.6, 0.7))
    page.mouse.up()
    page.wait_for_timeout(150)
    near = scale(page, 0)
    is_log = page.evaluate("plots[0].spec.x.log")
    share = (near[1] - near[0]) / (whole[1] - whole[0])
    if not (0.1 < share < 0.6 if not is_log else share < 0.8):
        fault(name, f"zoomed to {share} of the whole")
    if colours(page, 0) == 0 and not is_map:
        fault(name, "nothing is left after a zoom")
    if shares > 1:
        others = page.evaluate(
            "plots.filter(plot => plot.spec.cursor === plots[0].spec.cursor).map(plot => plot.u.scales.x.max)"
        )
        if max(others) - min(others) > 1e-6 * abs(near[1]):
            fault(name, "charts of one cursor are not zoomed together")
    page.keyboard.down("Shift")
    page.mouse.move(*at(0.5))
    page.mouse.down()
    page.mouse.move(*at(0.6))
    page.mouse.up()
    page.keyboard.up("Shift")
    page.wait_for_timeout(100)
    if not scale(page, 0)[0] < near[0]:
        fault(name, "shift and drag do not move it")
    page.mouse.dblclick(*at(0.5))
    page.wait_for_timeout(150)
    again = scale(page, 0)
    if max(abs(a - b) for a, b in zip(again, whole)) > 1e-6 * abs(whole[1]):
        fault(name, f"a double click shows {again} of {whole}")
    page.locator(".draw").first.focus()
    page.keyboard.press("+")
    page.wait_for_timeout(100)
    closer = scale(page, 0)
    page.keyboard.press("0")
    page.wait_for_timeout(100)
    if not closer[1] < whole[1] or abs(scale(page, 0)[1] - whole[1]) > 1e-6 * abs(whole[1]):
        fault(name, f"keys show {closer}, {scale(page, 0)} of {whole}")
    legend = page.locator(".legend button").first
    if legend.count():
        legend.click()
        if legend.get_attribute("aria-pressed") != "false" or page.evaluate(
            "!plots.some(plot => plot.spec.layers.some(layer => !layer.shown))"
        ):
            fault(name, "the legend hides nothing")
        legend.click()
    for form in ["PNG", "SVG", "CSV"]:
        with page.expect_download() as download:
            page.locator("figure.plot").first.get_by_text(form, exact=True).click()
        saved = Path(download.value.path()).read_bytes()
        if form == "PNG" and not saved.startswith(b"\x89PNG"):
            fault(name, "its PNG is none")
        if form == "SVG":
            tree = xml.etree.ElementTree.fromstring(saved)
            if len(tree.findall(".//{http://www.w3.org/2000/svg}path")) < 5 or b"NaN" in saved:
                fault(name, "its SVG is empty or has what is no number")
        if form == "CSV" and (saved.count(b"\n") < 2 or not saved.startswith(b"series,")):
            fault(name, f"its CSV is {saved[:80]}")


def pinched(name, page):
    """Two fingers that part show less of the first chart."""
    if page.locator("figure.plot").count() == 0 or page.evaluate("plots[0].spec.map"):
        return
    whole = scale(page, 0)
    page.evaluate(
        """() => {
          const over = plots[0].u.over, { left, top, width } = over.getBoundingClientRect();
          const touch = (type, parts) => over.dispatchEvent(new TouchEvent(type, { cancelable: true, touches: parts.map(
            (part, identifier) => new Touch({ identifier, target: over, clientX: left + part * width, clientY: top + 20 })) }));
          touch("touchstart", [0.4, 0.6]);
          touch("touchmove", [0.2, 0.8]);
        }"""
    )
    page.wait_for_timeout(100)
    near = scale(page, 0)
    share = (near[1] - near[0]) / (whole[1] - whole[0])
    if not page.evaluate("plots[0].spec.x.log") and abs(share - 1 / 3) > 0.01:
        fault(name, f"two fingers show {share} of the whole, not a third")


def budget(page):
    """A tighter budget costs more, and words choose."""
    def cheapest():
        return page.evaluate("[...document.querySelectorAll('#cheapest td')].map(cell => cell.textContent)")

    loose = cheapest()
    page.locator("#budget").evaluate("slider => { slider.value = -7; slider.dispatchEvent(new Event('input')); }")
    tight = cheapest()
    page.locator("#words").fill("textbook")
    page.wait_for_timeout(100)
    textbook = cheapest()
    if loose == tight or not all("textbook" in name or "nothing" in name for name in textbook[1::4]):
        fault("frontier", f"budget and words choose {loose}, {tight}, {textbook}")
    page.locator("#words").fill("")


def accessible(name, page, how):
    found = Axe().run(page)["violations"]
    for violation in found:
        if violation["impact"] in ("serious", "critical"):
            where = [node["target"] for node in violation["nodes"]][:3]
            fault(name, f"{how}: {violation['id']} ({violation['impact']}): {violation['help']}, at {where}")


def fits(name, page, how):
    wide = page.evaluate("document.documentElement.scrollWidth - innerWidth")
    if wide > 0:
        fault(name, f"{how}: {wide} pixels wider than the window")
    beyond = page.evaluate(
        """[...document.querySelectorAll('figure.plot')].filter(figure =>
          figure.querySelector('canvas').getBoundingClientRect().right > figure.getBoundingClientRect().right + 1).length"""
    )
    if beyond:
        fault(name, f"{how}: {beyond} charts are wider than their figures")


def main():
    chromium, folder, *names = sys.argv[1:]
    folder = Path(folder).resolve()
    shots = os.environ.get("SHOTS")
    pages = sorted(folder.glob("*/*.html"))
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        for path in pages:
            name = path.parent.name
            views = [("light", 1280, "light"), ("dark", 1280, "dark"), ("narrow", 380, "light")]
            for how, width, scheme in views[:1] if name in ALIKE else views:
                page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=scheme)
                page.on("console", lambda message: fault(name, f"{message.type}: {message.text}"))
                page.on("pageerror", lambda error: fault(name, f"error: {error}"))
                page.on("request", lambda request: None if request.url.startswith(("file:", "blob:")) else fault(name, request.url))
                page.goto(path.as_uri())
                page.wait_for_timeout(150)
                drawn(name, page)
                fits(name, page, how)
                if shots:
                    page.screenshot(path=f"{shots}/{name}-{how}.png", full_page=True)
                if how == "light":
                    used(name, page)
                    if name == "frontier":
                        budget(page)
                if how == "narrow":
                    pinched(name, page)
                accessible(name, page, how)
                if how == "light":
                    page.emulate_media(media="print", color_scheme="dark")
                    page.set_viewport_size({"width": 690, "height": 900})
                    page.evaluate("dispatchEvent(new Event('beforeprint'))")
                    page.wait_for_timeout(150)
                    paper = page.evaluate("getComputedStyle(document.documentElement).getPropertyValue('--paper').trim()")
                    if paper != "#ffffff":
                        fault(name, f"is printed on {paper}")
                    fits(name, page, "print")
                    page.evaluate("dispatchEvent(new Event('afterprint'))")
                    if shots:
                        page.pdf(path=f"{shots}/{name}.pdf", format="A4")
                page.close()
            print(f"{name}: looked at", flush=True)
        browser.close()
    for line in dict.fromkeys(faults):
        print(line, file=sys.stderr)
    missing = set(names or CHARTS) - {path.parent.name for path in pages}
    print(f"{len(pages)} pages, {len(faults)} faults" + (f", without {missing}" if missing else ""))
    if missing or faults:
        sys.exit(1)


main()
