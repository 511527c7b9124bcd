package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * A file that is to be edited, as text from which its bytes come back exactly.
 *
 * @param name for messages
 * @param text its content
 * @param charset how the text becomes the bytes again
 */
public record BaseFile(String name, String text, Charset charset) {

  /**
   * Reads a file.
   *
   * @param file from where
   * @return its text
   * @throws InputException when there is no such file or it is not text
   * @throws IOException when it cannot be read
   */
  public static BaseFile read(Path file) throws IOException {
    return of(file.toString(), JsonFiles.bytes(file));
  }

  /**
   * Text from bytes: UTF-8, or else Latin-1, in which older programs write and every byte is a character.
   *
   * @param name for messages
   * @param bytes the content
   * @return the text
   * @throws InputException when it is not text
   */
  public static BaseFile of(String name, byte[] bytes) throws InputException {
    for (int i = 0; i < bytes.length; i++) {
      if (bytes[i] == 0) {
        throw new InputException(
            name + ", byte " + i + ": is binary, not a configuration file in text form");
      }
    }
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      return new BaseFile(name, text, StandardCharsets.UTF_8);
    } catch (CharacterCodingException e) {
      return new BaseFile(
          name, new String(bytes, StandardCharsets.ISO_8859_1), StandardCharsets.ISO_8859_1);
    }
  }

  /** The line of a character, counted from 1. */
  int line(int index) {
    return 1 + (int) text.substring(0, index).chars().filter(c -> c == '\n').count();
  }

  /** An error at a character. */
  InputException error(int index, String what) {
    return new InputException(name + ", line " + line(index) + ": " + what);
  }
}
