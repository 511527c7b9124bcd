package fieldcal.testing;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolutionException;
import org.junit.jupiter.api.extension.ParameterResolver;

/** Reads what {@link RecordedKicks} names, once for all tests of a run. */
final class RecordedKicksExtension implements ParameterResolver {
  private static final ExtensionContext.Namespace READ =
      ExtensionContext.Namespace.create(RecordedKicksExtension.class);

  /** JUnit makes it. */
  RecordedKicksExtension() {}

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext test) {
    return parameter.getParameter().getType() == Recorded.class;
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext test) {
    RecordedKicks wanted = annotation(test);
    Path recording = Path.of(wanted.value());
    Path expected =
        wanted.expected().isEmpty()
            ? Recorded.expectationsOf(recording)
            : Path.of(wanted.expected());
    return test.getRoot()
        .getStore(READ)
        .getOrComputeIfAbsent(
            recording.toAbsolutePath() + "\n" + expected.toAbsolutePath(),
            key -> read(recording, expected),
            Recorded.class);
  }

  private static RecordedKicks annotation(ExtensionContext test) {
    RecordedKicks onMethod = test.getRequiredTestMethod().getAnnotation(RecordedKicks.class);
    return onMethod != null
        ? onMethod
        : test.getRequiredTestClass().getAnnotation(RecordedKicks.class);
  }

  private static Recorded read(Path recording, Path expected) {
    try {
      return Recorded.read(recording, expected);
    } catch (IOException e) {
      throw new ParameterResolutionException(e.getMessage(), e);
    }
  }
}
