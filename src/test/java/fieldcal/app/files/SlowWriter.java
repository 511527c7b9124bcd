package fieldcal.app.files;

import java.io.IOException;
import java.nio.file.Path;

/** A program that writes a file and never gets done with it, for a test that ends it. */
final class SlowWriter {
  private SlowWriter() {}

  /**
   * Writes.
   *
   * @param args the file
   * @throws IOException when it cannot
   */
  public static void main(String[] args) throws IOException {
    WholeFile.stream(
        Path.of(args[0]),
        to -> {
          to.write("the first half of it");
          System.out.println("writing");
          System.out.flush();
          try {
            Thread.sleep(60_000);
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
  }
}
