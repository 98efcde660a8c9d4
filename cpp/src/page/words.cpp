// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/words.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "base/number_text.h"
#include "swept/types.h"

namespace swept::page {
namespace {

constexpr std::array kTexts{
    Word{"title_clearance", "Clearance report", "Abstandsbericht"},
    Word{"title_mechanism", "Clearance report of a mechanism", "Abstandsbericht eines Mechanismus"},
    Word{"title_study", "Study", "Studie"},
    // --- studies
    Word{"runs", "Runs", "Läufe"},
    Word{"run", "Run", "Lauf"},
    Word{"state", "State", "Zustand"},
    Word{"done", "done", "fertig"},
    Word{"not_clear", "not clear", "nicht frei"},
    Word{"failed", "failed", "fehlgeschlagen"},
    Word{"not_run", "not run", "nicht gerechnet"},
    Word{"all_runs_good", "All {0} runs are done, and all their rules are met.",
         "Alle {0} Läufe sind fertig, und alle ihre Regeln sind erfüllt."},
    Word{"one_run_good", "The run is done, and all its rules are met.",
         "Der Lauf ist fertig, und alle seine Regeln sind erfüllt."},
    Word{"runs_good", "{0} of {1} runs are done and meet their rules.",
         "{0} von {1} Läufen sind fertig und erfüllen ihre Regeln."},
    Word{"look_first", "Look first at:", "Zuerst ansehen:"},
    Word{"worst_neighbour", "Worst neighbour", "Kritischster Nachbar"},
    Word{"volume", "Volume of the envelope", "Volumen der Hülle"},
    Word{"envelope_triangles", "triangles", "Dreiecke"},
    Word{"faces", "faces of the solid", "Flächen des Festkörpers"},
    Word{"page", "Page", "Seite"},
    Word{"page_link", "open", "öffnen"},
    Word{"own_page", "Page of this run", "Seite dieses Laufs"},
    // --- the verdict
    Word{"all_met", "All {0} checked pairs meet their rules.",
         "Alle {0} geprüften Paare erfüllen ihre Regeln."},
    Word{"one_met", "The checked pair meets its rule.", "Das geprüfte Paar erfüllt seine Regel."},
    Word{"not_met", "{0} of {1} checked pairs do not meet their rules.",
         "{0} von {1} geprüften Paaren erfüllen ihre Regeln nicht."},
    Word{"one_not_met", "1 of {1} checked pairs does not meet its rule.",
         "1 von {1} geprüften Paaren erfüllt seine Regel nicht."},
    Word{"none_near", "No pair comes closer than the largest distance that was checked.",
         "Kein Paar kommt sich näher als der größte geprüfte Abstand."},
    Word{"nothing_checked", "No pair was checked, because the rules ignore every neighbour.",
         "Kein Paar wurde geprüft, weil die Regeln alle Nachbarn ignorieren."},
    Word{"nearest", "Smallest distance: {0} at {1}", "Kleinster Abstand: {0} bei {1}"},
    Word{"deepest", "Deepest clash: {0} at {1}", "Tiefste Kollision: {0} bei {1}"},
    Word{"clear", "clear", "frei"},
    Word{"below", "below required", "unter Sollabstand"},
    Word{"contact", "contact", "Kontakt"},
    Word{"allowed", "allowed contact", "erlaubter Kontakt"},
    Word{"clash", "clash", "Kollision"},
    Word{"ignored", "ignored", "ignoriert"},
    Word{"promise",
         "The whole motion was checked, not only the poses: at no time are the parts closer to "
         "each other than the guaranteed distance.",
         "Die ganze Bewegung wurde geprüft, nicht nur die Lagen: Zu keinem Zeitpunkt sind die "
         "Teile näher beieinander als der garantierte Abstand."},
    Word{"promise_copies", "Only the given poses were checked, not the motion between them.",
         "Nur die angegebenen Lagen wurden geprüft, nicht die Bewegung dazwischen."},
    // --- headings
    Word{"verdicts", "Verdicts", "Urteile"},
    Word{"graph", "Distance over time", "Abstand über der Zeit"},
    Word{"view", "3D view", "3D-Ansicht"},
    Word{"pictures", "Pictures", "Bilder"},
    Word{"rules", "Rules", "Regeln"},
    Word{"inputs", "Inputs", "Eingaben"},
    Word{"findings", "Findings", "Befunde"},
    Word{"settings", "Settings", "Einstellungen"},
    // --- tables
    Word{"pair", "Pair", "Paar"},
    Word{"neighbour", "Neighbour", "Nachbar"},
    Word{"verdict", "Verdict", "Urteil"},
    Word{"distance", "Distance", "Abstand"},
    Word{"guaranteed", "Guaranteed", "Garantiert"},
    Word{"time", "At time", "Zeitpunkt"},
    Word{"depth", "Depth", "Tiefe"},
    Word{"depth_range", "{0} to {1}", "{0} bis {1}"},
    Word{"depth_unknown", "not measured", "nicht gemessen"},
    Word{"below_for", "Below required for", "Unter Sollabstand während"},
    Word{"rule", "Rule", "Regel"},
    Word{"rule_required", "at least {0}", "mindestens {0}"},
    Word{"rule_none", "no clash", "keine Kollision"},
    Word{"rule_contact", "contact allowed", "Kontakt erlaubt"},
    Word{"rule_depth", "contact allowed, at most {0} deep", "Kontakt erlaubt, höchstens {0} tief"},
    Word{"rule_ignore", "not checked", "nicht geprüft"},
    Word{"met", "Met", "Erfüllt"},
    Word{"yes", "yes", "ja"},
    Word{"no", "no", "nein"},
    Word{"joined", "do not move relative to each other", "bewegen sich nicht relativ zueinander"},
    // --- settings
    Word{"setting", "Setting", "Einstellung"},
    Word{"value", "Value", "Wert"},
    Word{"required", "Required distance of pairs without a rule",
         "Sollabstand für Paare ohne Regel"},
    Word{"tolerance", "Accuracy of the smallest distances", "Genauigkeit der kleinsten Abstände"},
    Word{"interpolation", "Motion between two poses", "Bewegung zwischen zwei Lagen"},
    Word{"none", "none (poses only)", "keine (nur Lagen)"},
    Word{"linear", "linear", "linear"},
    Word{"screw", "screw", "Schraubung"},
    Word{"placements", "Poses", "Lagen"},
    Word{"witness", "Checked against", "Geprüft gegen"},
    Word{"witness_motion", "the motion of the moving part", "die Bewegung des bewegten Teils"},
    Word{"witness_envelope", "the envelope (standing still)", "die Hülle (stillstehend)"},
    Word{"body_triangles", "Triangles of the moving part", "Dreiecke des bewegten Teils"},
    Word{"neighbour_triangles", "Triangles of the neighbours", "Dreiecke der Nachbarn"},
    Word{"triangles", "Triangles of all parts", "Dreiecke aller Teile"},
    Word{"span", "Time", "Zeit"},
    Word{"span_text", "{0} to {1}", "{0} bis {1}"},
    Word{"range", "Largest distance of the pairs in the list",
         "Größter Abstand der aufgeführten Paare"},
    Word{"far_pairs", "Number of pairs that stay farther apart",
         "Anzahl der Paare, die weiter entfernt bleiben"},
    // --- inputs and findings
    Word{"role", "Role", "Rolle"},
    Word{"name", "Name", "Name"},
    Word{"detail", "Details", "Angaben"},
    Word{"sha256", "SHA-256", "SHA-256"},
    Word{"hash_unknown", "not known", "nicht bekannt"},
    Word{"role_body", "moving part", "bewegtes Teil"},
    Word{"role_motion", "motion", "Bewegung"},
    Word{"role_neighbour", "part that stands still", "stillstehendes Teil"},
    Word{"role_rules", "rules", "Regeln"},
    Word{"role_study", "study", "Studie"},
    Word{"no_findings", "None.", "Keine."},
    Word{"findings_language", "The findings are in English only.",
         "Die Befunde gibt es nur auf Englisch."},
    // --- graph and view
    Word{"axis_time", "time (s)", "Zeit (s)"},
    Word{"axis_distance", "distance (mm)", "Abstand (mm)"},
    Word{"others", "others", "weitere"},
    Word{"graph_required", "required: {0}", "gefordert: {0}"},
    Word{"graph_scale", "The distance axis is linear near 0 and logarithmic above.",
         "Die Achse der Abstände ist nahe 0 linear und darüber logarithmisch."},
    Word{"graph_names", "Point at a curve to see its name.",
         "Zeigen Sie auf eine Kurve, um ihren Namen zu sehen."},
    Word{"graph_range", "Distances above {0} were not measured exactly.",
         "Abstände über {0} wurden nicht genau gemessen."},
    Word{"view_play", "Play", "Abspielen"},
    Word{"view_pause", "Pause", "Anhalten"},
    Word{"view_reset", "Whole view", "Gesamtansicht"},
    Word{"view_time", "Time", "Zeit"},
    Word{"view_worst", "Go to", "Gehe zu"},
    Word{"view_parts", "Parts", "Teile"},
    Word{"view_simplified",
         "The shapes shown are simplified ({0} of {1} triangles). All results were computed with "
         "the full shapes.",
         "Die gezeigten Formen sind vereinfacht ({0} von {1} Dreiecken). Alle Ergebnisse wurden "
         "mit den vollen Formen berechnet."},
    Word{"view_full", "Shapes are shown with all {0} triangles.",
         "Die Formen werden mit allen {0} Dreiecken gezeigt."},
    Word{"view_needs", "The 3D view needs JavaScript and WebGL in the browser.",
         "Die 3D-Ansicht braucht JavaScript und WebGL im Browser."},
    Word{"view_not_built", "There is no 3D view, because this program was built without three.js.",
         "Es gibt keine 3D-Ansicht, weil dieses Programm ohne three.js kompiliert wurde."},
    Word{"made_by", "Made by {0}", "Erstellt mit {0}"},
};

}  // namespace

std::span<const Word> allWords() { return kTexts; }

Words::Words(const std::string& language) : language_(language) {
  if (language != "en" && language != "de")
    throw Error(Status::InvalidInput, "BadOption",
                "language is '" + language + "'; allowed: en, de");
}

bool Words::has(const std::string& key) const {
  for (const Word& word : kTexts)
    if (key == word.key) return true;
  return false;
}

std::string Words::operator()(const std::string& key, const std::string& zero,
                              const std::string& one) const {
  for (const Word& word : kTexts) {
    if (key != word.key) continue;
    const std::string text = language_ == "de" ? word.german : word.english;
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const std::string mark = text.substr(i, 3);
      if (mark != "{0}" && mark != "{1}") {
        out += text[i];
        continue;
      }
      out += mark == "{0}" ? zero : one;
      i += 2;
    }
    return out;
  }
  throw std::logic_error("no text for '" + key + "' in pages");
}

std::string Words::number(double value, int digits) const {
  constexpr double kNothing = 1e-9;  // mm or s: smaller values are rounding errors
  std::string text = numberText(std::abs(value) < kNothing ? 0.0 : value, digits);
  if (language_ == "de")
    for (char& c : text)
      if (c == '.') c = ',';
  return text;
}

}  // namespace swept::page
