package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.stream.StreamSupport;
import org.openqa.selenium.By;
import org.openqa.selenium.JavascriptExecutor;
import org.openqa.selenium.Keys;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.StaleElementReferenceException;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.logging.LogEntry;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;
import org.openqa.selenium.support.ui.ExpectedCondition;
import org.openqa.selenium.support.ui.WebDriverWait;

/** Debian's chromium as an operator uses it, on a small laptop's screen. */
final class Browser implements AutoCloseable {
  private static final List<String> BROWSERS =
      List.of("/usr/bin/chromium", "/usr/bin/chromium-browser");
  private static final List<String> DRIVERS =
      List.of("/usr/bin/chromedriver", "/usr/lib/chromium-browser/chromedriver");
  private static final Duration PATIENCE = Duration.ofSeconds(90);

  private final ChromeDriver driver;

  Browser() {
    this(1280, 720);
  }

  Browser(int width, int height) {
    ChromeOptions options = new ChromeOptions();
    options.setBinary(find("chromium", BROWSERS));
    options.addArguments(
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--hide-scrollbars",
        "--no-proxy-server");
    LoggingPreferences logs = new LoggingPreferences();
    logs.enable(LogType.BROWSER, Level.ALL);
    options.setCapability("goog:loggingPrefs", logs);
    ChromeDriverService service =
        new ChromeDriverService.Builder()
            .usingDriverExecutable(new File(find("chromedriver", DRIVERS)))
            .usingAnyFreePort()
            .build();
    driver = new ChromeDriver(service, options);
    driver.manage().timeouts().scriptTimeout(PATIENCE);
    resize(width, height);
  }

  /** Another screen. */
  void resize(int width, int height) {
    driver.executeCdpCommand(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", false));
  }

  /** A test that cannot have a browser must not pass for one that was not run. */
  private static String find(String what, List<String> places) {
    return places.stream()
        .filter(place -> Files.isExecutable(Path.of(place)))
        .findFirst()
        .orElseGet(
            () ->
                fail(
                    "no %s in %s: apt-get install chromium chromium-driver (./gradlew test does it"
                        + " as root or by sudo)",
                    what, places));
  }

  void open(String url) {
    driver.get(url);
  }

  /** Another window beside the present one, which becomes the present one. */
  String openBeside(String url) {
    String before = driver.getWindowHandle();
    driver.switchTo().newWindow(org.openqa.selenium.WindowType.TAB);
    driver.get(url);
    return before;
  }

  void switchTo(String window) {
    driver.switchTo().window(window);
  }

  String window() {
    return driver.getWindowHandle();
  }

  WebElement find(String css) {
    return await("there is " + css, d -> d.findElement(By.cssSelector(css)));
  }

  int count(String css) {
    return driver.findElements(By.cssSelector(css)).size();
  }

  /** Chooses a value of a list. */
  void choose(String css, String value) {
    find(css);
    script(
        "const list = document.querySelector(arguments[0]); list.value = arguments[1];"
            + " list.dispatchEvent(new Event('change'))",
        css,
        value);
  }

  void click(String css) {
    await(
        css + " is pressed",
        d -> {
          d.findElement(By.cssSelector(css)).click();
          return true;
        });
  }

  void type(String css, String text) {
    await(
        css + " takes text",
        d -> {
          WebElement field = d.findElement(By.cssSelector(css));
          field.clear();
          field.sendKeys(text);
          return true;
        });
  }

  /** Presses keys with nothing in focus. */
  void press(CharSequence keys) {
    script("document.activeElement.blur()");
    new Actions(driver).sendKeys(keys).perform();
  }

  /** Presses keys in what has the focus. */
  void pressHere(CharSequence keys) {
    new Actions(driver).sendKeys(keys).perform();
  }

  /** Presses keys in what has the focus while another one is held. */
  void pressHere(Keys held, CharSequence keys) {
    new Actions(driver).keyDown(held).sendKeys(keys).keyUp(held).perform();
  }

  /** Goes on with the tabulator until something has the focus. */
  void tabTo(String css) {
    for (int i = 0; i < 60 && !hasFocus(css); i++) {
      pressHere(Keys.TAB);
    }
    assertThat(hasFocus(css)).as("the tabulator reaches %s", css).isTrue();
  }

  /** Goes on with the tabulator until something has the focus, and presses it. */
  void tabToAndEnter(String css) {
    tabTo(css);
    pressHere(Keys.ENTER);
  }

  void awaitFocus(String css) {
    await(css + " has the focus", d -> hasFocus(css) ? true : null);
  }

  private boolean hasFocus(String css) {
    return Boolean.TRUE.equals(script("return document.activeElement.matches(arguments[0])", css));
  }

  String text(String css) {
    // In one step: the page may draw an element again between finding and reading it.
    return await(css + " is read", d -> d.findElement(By.cssSelector(css)).getText());
  }

  void awaitText(String css, String part) {
    await(
        css + " says " + part,
        d -> d.findElement(By.cssSelector(css)).getText().contains(part) ? true : null);
  }

  void awaitGone(String css) {
    await("no " + css, d -> d.findElements(By.cssSelector(css)).isEmpty() ? true : null);
  }

  Object script(String code, Object... arguments) {
    return ((JavascriptExecutor) driver).executeScript(code, arguments);
  }

  /** Runs a script that calls its last argument with the answer, sooner or later. */
  Object scriptThatAnswers(String code, Object... arguments) {
    return ((JavascriptExecutor) driver).executeAsyncScript(code, arguments);
  }

  /** A command of the browser's own protocol for tools. */
  Map<String, Object> command(String name, Map<String, Object> parameters) {
    return driver.executeCdpCommand(name, parameters);
  }

  /** Drags within an element, from and to fractions of its size. */
  void drag(String css, double x0, double y0, double x1, double y1) {
    WebElement box = find(css);
    int w = box.getSize().width;
    int h = box.getSize().height;
    new Actions(driver)
        .moveToElement(box, (int) ((x0 - 0.5) * w), (int) ((y0 - 0.5) * h))
        .clickAndHold()
        .moveByOffset((int) ((x1 - x0) * w / 2), (int) ((y1 - y0) * h / 2))
        .moveByOffset((int) ((x1 - x0) * w / 2), (int) ((y1 - y0) * h / 2))
        .release()
        .perform();
  }

  <T> T await(String what, ExpectedCondition<T> condition) {
    return new WebDriverWait(driver, PATIENCE, Duration.ofMillis(100))
        .withMessage(what)
        .ignoring(StaleElementReferenceException.class)
        .ignoring(org.openqa.selenium.WebDriverException.class)
        .until(condition);
  }

  /** What the page's scripts complained about, but for connections that the test itself cut and requests that are to be refused. */
  void assertNoComplaints() {
    List<String> complaints =
        StreamSupport.stream(driver.manage().logs().get(LogType.BROWSER).spliterator(), false)
            .filter(entry -> entry.getLevel().intValue() >= Level.WARNING.intValue())
            .map(LogEntry::getMessage)
            .filter(message -> !message.contains("net::ERR_"))
            .filter(message -> !message.matches(".*status of (400|401|409) .*"))
            .toList();
    assertThat(complaints).isEmpty();
  }

  /** A picture of the page once it is drawn. */
  void screenshot(Path file) throws IOException {
    awaitGone("[data-waiting]");
    Files.write(file, driver.getScreenshotAs(OutputType.BYTES));
  }

  @Override
  public void close() {
    driver.quit();
  }
}
