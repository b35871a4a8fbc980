#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives the replay page in a headless browser: page_test.py WRITE_PAGES [KEEP_SCREENSHOTS_IN]"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select

WRITE_PAGES = sys.argv[1]
KEEP = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None

# A copy of the map's canvas, so that reading pixels leaves the page's own canvas as it is.
COPY = """
const canvas = document.getElementById('map'), copy = document.createElement('canvas');
copy.width = canvas.width;
copy.height = canvas.height;
const pixels = copy.getContext('2d', {willReadFrequently: true});
pixels.drawImage(canvas, 0, 0);
"""

# The colour of the canvas at (x, y) metres, straight from its pixels.
PIXEL = COPY + """
const [x, y] = arguments, view = krait.view;
const ratio = canvas.width / canvas.getBoundingClientRect().width;
const px = canvas.width / 2 + (x - view.x) * view.scale * ratio, py = canvas.height / 2 - (y - view.y) * view.scale * ratio;
return Array.from(pixels.getImageData(Math.round(px), Math.round(py), 1, 1).data).slice(0, 3);
"""

# How many pixels within r metres of (x, y) are nearly white.
WHITE_PIXELS = COPY + """
const [x, y, r] = arguments, view = krait.view;
const ratio = canvas.width / canvas.getBoundingClientRect().width;
const px = canvas.width / 2 + (x - view.x) * view.scale * ratio, py = canvas.height / 2 - (y - view.y) * view.scale * ratio;
const size = Math.max(1, Math.round(2 * r * view.scale * ratio));
const data = pixels.getImageData(Math.round(px - size / 2), Math.round(py - size / 2), size, size).data;
let count = 0;
for (let i = 0; i < data.length; i += 4) count += Math.min(data[i], data[i + 1], data[i + 2]) > 200;
return count;
"""

# The canvas's pixels as one number.
FINGERPRINT = COPY + """
const data = pixels.getImageData(0, 0, canvas.width, canvas.height).data;
let hash = 17;
for (let i = 0; i < data.length; i += 4) hash = (Math.imul(hash, 31) + (data[i] << 16 | data[i + 1] << 8 | data[i + 2])) | 0;
return hash;
"""

SET_VALUE = """
arguments[0].value = arguments[1];
arguments[0].dispatchEvent(new Event('input', {bubbles: true}));
"""

NEXT_FRAME = "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));"

VIOLET = (0x6A, 0x2C, 0xA8)
GOAL = (0xFF, 0xD5, 0x1F)
OBSTACLE = (0x3A, 0x41, 0x4D)


def open_browser():
    options = Options()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
                     "--disable-background-networking", "--window-size=1280,860"):
        options.add_argument(argument)
    options.binary_location = "/usr/bin/chromium"
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    browser.set_script_timeout(20)
    return browser


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        subprocess.run([WRITE_PAGES, cls.directory.name], check=True)
        cls.browser = open_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.directory.cleanup()

    def setUp(self):
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "light"}]})

    def tearDown(self):
        if KEEP:
            KEEP.mkdir(parents=True, exist_ok=True)
            self.browser.save_screenshot(str(KEEP / f"{self._testMethodName}.png"))
        complaints = [entry["message"] for entry in self.browser.get_log("browser")]
        self.assertEqual(complaints, [], "the console is not silent")
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] in ("Network.requestWillBeSent", "Network.webSocketCreated"):
                url = message["params"].get("request", message["params"])["url"]
                self.assertTrue(url.startswith(("file://" + self.directory.name, "data:")), f"the page asked for {url}")

    # ---- helpers
    def open(self, name):
        self.browser.get("file://" + os.path.join(self.directory.name, name + ".html"))
        self.settle()

    def settle(self):
        self.browser.execute_async_script(NEXT_FRAME)

    def state(self, name):
        return self.browser.execute_script("return krait[arguments[0]]", name)

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def click(self, name):
        self.element(name).click()
        self.settle()

    def press(self, *keys):
        self.browser.find_element(By.ID, "map").send_keys(*keys)
        self.settle()

    def scrub(self, value):
        self.browser.execute_script(SET_VALUE, self.element("scrub"), value)
        self.settle()

    def choose(self, name, value):
        Select(self.element(name)).select_by_value(value)
        self.settle()

    def pixel(self, x, y):
        return tuple(self.browser.execute_script(PIXEL, x, y))

    # Zooms in as far as the wheel does in ten steps at (x, y) metres.
    def zoom_at(self, x, y):
        for _ in range(10):
            left, top = self.browser.execute_script(
                """const [x, y] = arguments, v = krait.view, b = document.getElementById('map').getBoundingClientRect();
                return [b.left + b.width / 2 + (x - v.x) * v.scale, b.top + b.height / 2 - (y - v.y) * v.scale];""", x, y)
            self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
                "type": "mouseWheel", "x": left, "y": top, "deltaX": 0, "deltaY": -120})
            self.settle()

    def fingerprint(self):
        return self.browser.execute_script(FINGERPRINT)

    def assertColor(self, found, wanted):
        self.assertTrue(all(abs(a - b) <= 3 for a, b in zip(found, wanted)), f"{found} is not {wanted}")

    def readings(self):
        cells = self.element("readings").text.split("\n")
        return dict(zip(cells[0::2], cells[1::2]))

    # ---- tests
    def test_shows_scene(self):
        self.open("solved")
        self.click("layer-raised")
        self.assertEqual(self.browser.title, "synthetic S")
        self.assertColor(self.pixel(25, 17), OBSTACLE)
        self.assertColor(self.pixel(43, 42.5), GOAL)
        red, _, blue = self.pixel(42.7, 44.4)
        self.assertGreater(red, 2 * blue)
        red, _, blue = self.pixel(0.7, 0.4)
        self.assertGreater(blue, 2 * red)

    def test_plays_and_pauses(self):
        self.open("solved")
        self.assertFalse(self.state("playing"))
        before = self.fingerprint()
        self.click("play")
        self.assertTrue(self.state("playing"))
        self.assertEqual(self.element("play").get_attribute("aria-label"), "Pause")
        time.sleep(1)
        self.click("play")
        self.assertFalse(self.state("playing"))
        moved = self.state("time")
        self.assertGreater(moved, 0.4)
        self.assertLess(moved, 5)
        self.assertNotEqual(self.fingerprint(), before)
        time.sleep(0.3)
        self.assertEqual(self.state("time"), moved)

    def test_plays_to_the_end_and_then_from_the_beginning(self):
        self.open("solved")
        end = self.state("duration")
        self.scrub(end - 0.2)
        self.click("play")
        time.sleep(0.8)
        self.assertFalse(self.state("playing"))
        self.assertAlmostEqual(self.state("time"), end)
        self.click("play")
        self.assertLess(self.state("time"), end / 2)

    def test_speed_scales_time(self):
        self.open("solved")
        gone = {}
        for speed in ("1", "8"):
            self.choose("speed", speed)
            self.scrub(0)
            self.click("play")
            time.sleep(1)
            self.click("play")
            gone[speed] = self.state("time")
        self.assertGreater(gone["8"], 3 * gone["1"])

    def test_scrub_moves_the_robot(self):
        self.open("solved")
        self.click("layer-path")
        self.scrub(30)
        self.assertAlmostEqual(self.state("time"), 30)
        self.assertEqual(self.readings()["time"], "30.0 s")
        x, y = (float(self.readings()[axis].split()[0]) for axis in "xy")
        self.assertColor(self.pixel(x, y), VIOLET)
        self.scrub(0)
        self.assertNotEqual(self.pixel(x, y), VIOLET)

    def test_the_front_is_marked(self):
        self.open("solved")
        self.click("layer-path")
        self.scrub(30)
        where = [float(self.readings()[axis].split()[0]) for axis in "xy"]
        heading = math.radians(float(self.readings()["heading"].replace("−", "-").rstrip("°")))
        self.zoom_at(*where)
        ahead, behind = ([x + side * f(heading) for x, f in zip(where, (math.cos, math.sin))] for side in (0.2, -0.2))
        self.assertGreater(self.browser.execute_script(WHITE_PIXELS, *ahead, 0.1), 5)
        self.assertEqual(self.browser.execute_script(WHITE_PIXELS, *behind, 0.1), 0)

    def test_robots_of_other_models_move_and_are_read(self):
        for name, rate in (("unicycle", "turn rate"), ("diff_drive", "turn rate"), ("car", "steering")):
            self.open(name)
            self.click("layer-path")
            self.scrub(30)
            readings = self.readings()
            self.assertIn(rate, readings)
            self.assertAlmostEqual(float(readings["speed"].split()[0]), 2, delta=0.1)
            self.assertColor(self.pixel(*(float(readings[axis].split()[0]) for axis in "xy")), VIOLET)

    def test_reads_speed_and_steering(self):
        self.open("solved")
        self.scrub(30)
        self.assertEqual(self.readings()["speed"], "2.00 m/s")
        self.assertRegex(self.readings()["steering"], r"^−?\d+°$")
        self.element("state").click()
        self.settle()
        self.assertIn("theta15", self.element("state").text)

    def test_buttons_zoom_and_fit(self):
        self.open("solved")
        fitted, pixels = self.state("view"), self.fingerprint()
        self.click("zoom-in")
        self.assertAlmostEqual(self.state("view")["scale"], 1.5 * fitted["scale"])
        self.assertNotEqual(self.fingerprint(), pixels)
        self.click("zoom-out")
        self.click("zoom-out")
        self.assertLess(self.state("view")["scale"], fitted["scale"])
        self.click("fit")
        self.assertEqual(self.state("view"), fitted)
        self.assertEqual(self.fingerprint(), pixels)

    def test_wheel_zooms_where_the_pointer_is(self):
        self.open("solved")
        where = """const v = krait.view, b = document.getElementById('map').getBoundingClientRect();
                   return [v.x + (400 - b.left - b.width / 2) / v.scale, v.y - (300 - b.top - b.height / 2) / v.scale];"""
        before, scale = self.browser.execute_script(where), self.state("view")["scale"]
        self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
            "type": "mouseWheel", "x": 400, "y": 300, "deltaX": 0, "deltaY": -240})
        self.settle()
        time.sleep(0.2)
        self.assertGreater(self.state("view")["scale"], 1.2 * scale)
        for a, b in zip(before, self.browser.execute_script(where)):
            self.assertAlmostEqual(a, b, places=6)

    def test_drag_moves_the_map(self):
        self.open("solved")
        before = self.state("view")
        ActionChains(self.browser).click_and_hold(self.element("map")).move_by_offset(80, 40).release().perform()
        self.settle()
        after = self.state("view")
        self.assertAlmostEqual(after["x"], before["x"] - 80 / before["scale"], places=3)
        self.assertAlmostEqual(after["y"], before["y"] + 40 / before["scale"], places=3)

    def test_search_grows_the_tree_and_changes_the_costs(self):
        self.open("solved")
        self.choose("mode", "search")
        self.assertEqual(self.state("frame"), 0)
        self.assertEqual(self.state("vertices"), 1)
        narrow = self.pixel(10.7, 16.4)
        first = self.fingerprint()
        self.scrub(self.state("iterations") / 2)
        self.assertEqual(self.state("frame"), 0)  # raised costs are off at first
        self.click("layer-raised")
        vertices = self.state("vertices")
        self.assertGreater(vertices, 100)
        self.assertGreater(self.state("frame"), 5)
        self.assertNotEqual(self.pixel(10.7, 16.4), narrow)
        self.assertNotEqual(self.fingerprint(), first)
        self.scrub(self.state("iterations"))
        self.assertGreater(self.state("vertices"), vertices)
        self.choose("mode", "motion")
        self.assertEqual(self.state("time"), 0)

    def test_search_plays(self):
        self.open("solved")
        self.choose("mode", "search")
        self.click("play")
        time.sleep(0.8)
        self.click("play")
        self.assertGreater(self.state("iteration"), 100)
        self.assertLess(self.state("iteration"), self.state("iterations"))
        self.assertEqual(self.readings()["iteration"], str(int(self.state("iteration"))))

    def test_layers_come_and_go(self):
        self.open("solved")
        self.scrub(30)
        shown = self.fingerprint()
        self.click("layer-raised")
        self.assertNotEqual(self.fingerprint(), shown)
        self.click("layer-raised")
        self.assertEqual(self.fingerprint(), shown)
        for layer in ("triangles", "tree", "path", "bodies"):
            self.click("layer-" + layer)
            self.assertFalse(self.state("layers")[layer])
            self.assertNotEqual(self.fingerprint(), shown, layer)
            self.click("layer-" + layer)
            self.assertEqual(self.fingerprint(), shown, layer)

    def test_keyboard(self):
        self.open("solved")
        self.press(" ")
        self.assertTrue(self.state("playing"))
        self.press(" ")
        self.assertFalse(self.state("playing"))
        self.press(Keys.END)
        self.assertAlmostEqual(self.state("time"), self.state("duration"))
        self.press(Keys.HOME)
        self.assertEqual(self.state("time"), 0)
        self.press(Keys.ARROW_RIGHT)
        self.assertGreater(self.state("time"), 0)
        scale = self.state("view")["scale"]
        self.press("+")
        self.assertGreater(self.state("view")["scale"], scale)
        self.press("0")
        self.assertEqual(self.state("view")["scale"], scale)
        self.press("m")
        self.assertEqual(self.state("mode"), "search")

    def test_every_control_has_a_name(self):
        self.open("solved")
        for control in self.browser.find_elements(By.CSS_SELECTOR, "button, input, select, canvas"):
            self.assertTrue(control.accessible_name, control.get_attribute("outerHTML"))

    def test_without_plan_shows_the_search(self):
        self.open("unsolved")
        self.assertEqual(self.state("mode"), "search")
        header = self.browser.find_element(By.TAG_NAME, "header").text
        self.assertIn("budget_used · 1 tried most · 2 stops body 1", header)
        self.assertColor(self.pixel(3.75, 4), (0x17, 0x1b, 0x22))
        self.scrub(self.state("iterations"))
        self.assertGreater(self.state("vertices"), 5000)

    def test_bare_scene_has_nothing_to_play(self):
        self.open("bare")
        self.assertFalse(self.element("play").is_enabled())
        self.press(" ", "m", Keys.END)
        self.assertFalse(self.state("playing"))

    def test_small_and_large_scenes_fit(self):
        for name, side in (("small", 3), ("large", 400)):
            self.open(name)
            view = self.state("view")
            height = self.browser.execute_script("return document.getElementById('map').getBoundingClientRect().height")
            self.assertAlmostEqual(view["x"], side / 2)
            self.assertGreater(view["scale"] * side, 0.8 * height)
            self.assertColor(self.pixel(0.5 * side, 0.34 * side), OBSTACLE)
            self.settle()

    def test_hostile_names_run_nothing(self):
        self.open("hostile")
        self.assertIsNone(self.browser.execute_script("return window.hostile ?? null"))
        self.assertTrue(self.browser.title.startswith("</script><script>"))
        self.element("state").click()
        self.settle()
        self.assertIn("</script>", self.element("state").text)

    def test_svgs_are_strict_xml_and_shown(self):
        for name in ("solved", "hostile"):
            path = os.path.join(self.directory.name, name + ".svg")
            self.assertTrue(xml.etree.ElementTree.parse(path).getroot().tag.endswith("svg"))
            self.browser.get("file://" + path)
            self.assertEqual(self.browser.execute_script("return document.documentElement.tagName"), "svg")
            self.assertGreater(self.browser.execute_script("return document.documentElement.getBBox().width"), 700)

    def test_dark(self):
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark"}]})
        self.open("solved")
        self.assertLess(sum(self.pixel(-1, 25)), 150)
        ink, paper = self.browser.execute_script(
            "const style = getComputedStyle(document.body); return [style.color, style.backgroundColor];")
        brightness = [sum(map(int, color[color.index("(") + 1:-1].split(",")[:3])) for color in (ink, paper)]
        self.assertGreater(brightness[0], brightness[1] + 400)

    def test_phone(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True})
        self.open("solved")
        self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), 390)
        play = self.element("play").rect
        self.assertLess(play["y"] + play["height"], 844)
        self.assertGreaterEqual(min(play["width"], play["height"]), 44)
        self.scrub(30)
        x, y = (float(self.readings()[axis].split()[0]) for axis in "xy")
        self.assertColor(self.pixel(x, y), VIOLET)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
