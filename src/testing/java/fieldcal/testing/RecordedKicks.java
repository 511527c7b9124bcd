package fieldcal.testing;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Gives a test the kicks of a recording: the test has a parameter of type {@link Recorded}. On a class it holds for all its tests; a recording is read once.
 *
 * <pre>
 * &#64;Test
 * &#64;RecordedKicks("src/test/kicks/home.log.gz")
 * void theCarpetStays(Recorded kicks) {
 *   kicks.assertModelsStay();
 * }
 * </pre>
 */
@Documented
@Target({ElementType.METHOD, ElementType.TYPE})
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(RecordedKicksExtension.class)
public @interface RecordedKicks {
  /**
   * The recording.
   *
   * @return path of an SSL game log, .log or .log.gz, from the folder in which the tests run
   */
  String value();

  /**
   * The file with what is expected.
   *
   * @return its path; by default beside the recording, with {@code .expected} in place of {@code .log} or {@code .log.gz}
   */
  String expected() default "";
}
