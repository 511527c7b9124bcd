package fieldcal.app.cli;

import fieldcal.app.wording.Harmless;
import java.io.PrintWriter;
import java.io.Writer;

/** Lets nothing through to a terminal that would steer it; see {@link Harmless}. */
final class HarmlessWriter extends PrintWriter {
  HarmlessWriter(Writer out) {
    super(out, true);
  }

  @Override
  public void write(int c) {
    write(String.valueOf((char) c));
  }

  @Override
  public void write(char[] buffer, int offset, int length) {
    write(new String(buffer, offset, length));
  }

  @Override
  public void write(String text, int offset, int length) {
    String shown = Harmless.text(text.substring(offset, offset + length));
    super.write(shown, 0, shown.length());
  }
}
