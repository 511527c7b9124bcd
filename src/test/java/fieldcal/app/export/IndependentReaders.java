package fieldcal.app.export;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.google.protobuf.TextFormat;
import fieldcal.proto.SSL_GeometryData;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/** Small readers of the targets' files that share nothing with the writers: each finds one number by its path. */
final class IndependentReaders {
  private static final Pattern YAML_LINE =
      Pattern.compile("^( *)\"?([^\"#:{]+?)\"?:\\s*(.*?)\\s*(#.*)?$");

  private IndependentReaders() {}

  static double read(String form, byte[] file, List<String> path) throws Exception {
    return switch (form) {
      case "yaml" -> yaml(utf8(file), path);
      case "json" -> json(file, path);
      case "protobuf-text" -> path.size() > 1 ? geometry(utf8(file), path) : flat(utf8(file), path);
      case "vartypes-xml" -> vars(file, path);
      case "elements-xml" -> element(utf8(file), path);
      case "toml" -> toml(utf8(file), path);
      case "ini" -> toml(utf8(file), path);
      default -> throw new IllegalArgumentException(form);
    };
  }

  private static String utf8(byte[] file) {
    return new String(file, StandardCharsets.UTF_8);
  }

  /** By indentation; a flow mapping on one line is looked through. */
  private static double yaml(String text, List<String> path) {
    Deque<Integer> indents = new ArrayDeque<>();
    Deque<String> names = new ArrayDeque<>();
    for (String line : text.lines().toList()) {
      Matcher m = YAML_LINE.matcher(line);
      if (!m.matches()) {
        continue;
      }
      while (!indents.isEmpty() && indents.getLast() >= m.group(1).length()) {
        indents.removeLast();
        names.removeLast();
      }
      indents.add(m.group(1).length());
      names.add(m.group(2));
      List<String> here = List.copyOf(names);
      if (here.equals(path)) {
        return Double.parseDouble(m.group(3));
      }
      if (m.group(3).startsWith("{") && here.equals(path.subList(0, path.size() - 1))) {
        for (String part : m.group(3).replaceAll("[{}]", "").split(",")) {
          if (part.split(":")[0].strip().equals(path.get(path.size() - 1))) {
            return Double.parseDouble(part.split(":")[1].strip());
          }
        }
      }
    }
    throw new AssertionError("no " + path);
  }

  private static double json(byte[] file, List<String> path) throws Exception {
    JsonNode node = new ObjectMapper().readTree(file);
    for (String name : path) {
      node = node.get(name);
    }
    return node.doubleValue();
  }

  /** With protobuf's own parser and the league's message. */
  private static double geometry(String text, List<String> path) throws Exception {
    SSL_GeometryData.Builder data = SSL_GeometryData.newBuilder();
    TextFormat.Parser.newBuilder().setAllowUnknownFields(true).build().merge(text, data);
    var flat = data.getModels().getStraightTwoPhase();
    var chip = data.getModels().getChipFixedLoss();
    return switch (path.get(path.size() - 1)) {
      case "acc_slide" -> flat.getAccSlide();
      case "acc_roll" -> flat.getAccRoll();
      case "k_switch" -> flat.getKSwitch();
      case "damping_xy_first_hop" -> chip.getDampingXyFirstHop();
      case "damping_xy_other_hops" -> chip.getDampingXyOtherHops();
      case "damping_z" -> chip.getDampingZ();
      default -> throw new AssertionError(path);
    };
  }

  private static double flat(String text, List<String> path) {
    return text.lines()
        .map(line -> line.split(":"))
        .filter(parts -> parts[0].equals(path.get(0)))
        .mapToDouble(parts -> Double.parseDouble(parts[1].strip()))
        .findFirst()
        .orElseThrow();
  }

  private static double vars(byte[] file, List<String> path) throws Exception {
    Element at =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new ByteArrayInputStream(file))
            .getDocumentElement();
    for (String name : path) {
      at = child(at, name);
    }
    return Double.parseDouble(at.getTextContent().strip());
  }

  private static Element child(Element parent, String name) {
    for (Node n = parent.getFirstChild(); n != null; n = n.getNextSibling()) {
      if (n instanceof Element e && e.getAttribute("name").equals(name)) {
        return e;
      }
    }
    throw new AssertionError("no " + name + " in " + parent.getAttribute("name"));
  }

  private static double element(String text, List<String> path) {
    String name = Pattern.quote(path.get(1));
    Matcher m = Pattern.compile("<" + name + "[ >][^<]*</" + name + ">").matcher(text);
    if (!m.find()) {
      throw new AssertionError("no " + path);
    }
    return Double.parseDouble(m.group().replaceAll("^<[^>]*>|</.*$", ""));
  }

  /** Sections and assignments; an inline table is looked through. */
  private static double toml(String text, List<String> path) {
    String table = String.join(".", path.subList(0, path.size() - 1));
    String key = path.get(path.size() - 1);
    String section = "";
    boolean quoted = false;
    for (String line : text.lines().map(String::strip).toList()) {
      if (line.contains("\"\"\"")) {
        quoted ^= line.split("\"\"\"", -1).length == 2;
      } else if (!quoted && line.startsWith("[")) {
        section = line.substring(1, line.indexOf(']'));
      } else if (!quoted && line.contains("=")) {
        String name = line.substring(0, line.indexOf('=')).strip();
        String value = line.substring(line.indexOf('=') + 1).split("#")[0].strip();
        if (section.equals(table) && name.equals(key)) {
          return Double.parseDouble(value);
        }
        if (value.startsWith("{") && (section + "." + name).equals(table)) {
          return Arrays.stream(value.replaceAll("[{} ]", "").split(","))
              .filter(part -> part.startsWith(key + "="))
              .mapToDouble(part -> Double.parseDouble(part.substring(key.length() + 1)))
              .findFirst()
              .orElseThrow();
        }
      }
    }
    throw new AssertionError("no " + path);
  }
}
