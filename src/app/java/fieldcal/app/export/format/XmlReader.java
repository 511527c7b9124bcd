package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Function;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;

/** Where the text of each XML element stands. Nothing outside the file is ever read: no DTD, no external entity. */
final class XmlReader {
  private final BaseFile base;

  /** Names what an element is; null for one that is passed over with all that is in it. */
  private final Function<XMLStreamReader2, String> name;

  private final List<Leaf> leaves = new ArrayList<>();
  private final Deque<Open> open = new ArrayDeque<>();
  private String root;

  /** An element that is not closed yet. */
  private record Open(List<String> path, int textStart) {}

  XmlReader(BaseFile base, Function<XMLStreamReader2, String> name) {
    this.base = base;
    this.name = name;
  }

  /** The values in the elements, whose paths begin below the root. */
  List<Leaf> leaves() throws InputException {
    // Woodstox, being on the class path: the JDK's own reader does not say where a tag begins.
    XMLInputFactory factory = XMLInputFactory.newFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_COALESCING, false);
    // VarTypes and Sumatra write ':' into names without meaning a namespace.
    factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
    factory.setProperty("com.ctc.wstx.normalizeLFs", false);
    try {
      XMLStreamReader2 reader =
          (XMLStreamReader2) factory.createXMLStreamReader(new StringReader(base.text()));
      while (reader.hasNext()) {
        switch (reader.next()) {
          case XMLStreamConstants.START_ELEMENT -> begin(reader);
          case XMLStreamConstants.END_ELEMENT -> end(reader);
          default -> {
            // Text is taken from between the tags.
          }
        }
      }
      return leaves;
    } catch (XMLStreamException e) {
      int line = e.getLocation() == null ? 1 : Math.max(1, e.getLocation().getLineNumber());
      String words = e.getMessage().lines().findFirst().orElse("");
      throw new InputException(base.name() + ", line " + line + ": is not valid XML: " + words);
    }
  }

  String root() {
    return root == null ? "" : root;
  }

  private void begin(XMLStreamReader2 reader) throws XMLStreamException {
    int end = (int) reader.getLocationInfo().getEndingCharOffset();
    if (root == null) {
      root = reader.getLocalName();
      open.push(new Open(List.of(), -1));
      return;
    }
    String called = name.apply(reader);
    if (called == null) {
      reader.skipElement();
      return;
    }
    boolean empty = base.text().startsWith("/>", end - 2);
    open.push(new Open(YamlForm.and(open.peek().path(), called), empty ? -1 : end));
  }

  /** The value is the text between the start of an element and whatever tag or comment comes first. */
  private void end(XMLStreamReader2 reader) {
    Open closed = open.pop();
    if (closed.textStart() < 0) {
      return;
    }
    int start = closed.textStart();
    int end = base.text().indexOf('<', start);
    while (start < end && Character.isWhitespace(base.text().charAt(start))) {
      start++;
    }
    while (end > start && Character.isWhitespace(base.text().charAt(end - 1))) {
      end--;
    }
    leaves.add(new Leaf(closed.path(), start, end));
  }
}
