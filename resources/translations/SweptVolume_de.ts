<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Envelope that is checked, with its parts and its motion. The envelope can be coloured by distance</source>
        <translation>Hülle, deren Teile und Bewegung geprüft werden. Die Hülle kann nach dem Abstand eingefärbt werden</translation>
    </message>
    <message>
        <source>Parts that move together. Used if no envelope is given</source>
        <translation>Teile, die sich gemeinsam bewegen. Gilt, wenn keine Hülle angegeben ist</translation>
    </message>
    <message>
        <source>Motion of the parts. Used if no envelope is given</source>
        <translation>Bewegung der Teile. Gilt, wenn keine Hülle angegeben ist</translation>
    </message>
    <message>
        <source>Parts that stand still. A group or link stands for all the parts in it</source>
        <translation>Teile, die stillstehen. Eine Gruppe oder Verknüpfung steht für alle Teile darin</translation>
    </message>
    <message>
        <source>True: all other visible parts are neighbours, and the list Neighbours is not used</source>
        <translation>True: Alle anderen sichtbaren Teile sind Nachbarn, und die Liste Neighbours wird nicht verwendet</translation>
    </message>
    <message>
        <source>Distance that the parts must keep from the neighbours during the motion</source>
        <translation>Abstand, den die Teile während der Bewegung von den Nachbarn halten müssen</translation>
    </message>
    <message>
        <source>How far the triangle mesh of a solid may deviate from the solid. This deviation is subtracted from guaranteed distances</source>
        <translation>Wie weit das Dreiecksnetz eines Festkörpers vom Festkörper abweichen darf. Diese Abweichung wird von garantierten Abständen abgezogen</translation>
    </message>
    <message>
        <source>Neighbours, or groups of neighbours, that have their own rule</source>
        <translation>Nachbarn oder Gruppen von Nachbarn, die eine eigene Regel haben</translation>
    </message>
    <message>
        <source>The rule of each entry of RuleParts. Required: its own required distance. Contact: contact is allowed. Ignore: not checked</source>
        <translation>Die Regel jedes Eintrags von RuleParts. Required (Sollabstand): eigener Sollabstand. Contact (Kontakt): Kontakt ist erlaubt. Ignore (Ignorieren): nicht geprüft</translation>
    </message>
    <message>
        <source>A length (mm) for each entry of RuleParts. Rule Required: the required distance. Rule Contact: the largest depth to which the parts may overlap</source>
        <translation>Eine Länge (mm) für jeden Eintrag von RuleParts. Regel Required: der Sollabstand. Regel Contact: die größte Tiefe, bis zu der sich die Teile überschneiden dürfen</translation>
    </message>
    <message>
        <source>State of the result</source>
        <translation>Zustand des Ergebnisses</translation>
    </message>
    <message>
        <source>Result in one line</source>
        <translation>Ergebnis in einer Zeile</translation>
    </message>
    <message>
        <source>Number of neighbours checked</source>
        <translation>Anzahl der geprüften Nachbarn</translation>
    </message>
    <message>
        <source>Worst verdict of all rows: clear, below (below required), contact or clash</source>
        <translation>Schlechtestes Urteil aller Zeilen: clear (frei), below (unter Sollabstand), contact (Kontakt) oder clash (Kollision)</translation>
    </message>
    <message>
        <source>Smallest distance</source>
        <translation>Kleinster Abstand</translation>
    </message>
    <message>
        <source>Report of the run (JSON)</source>
        <extracomment>The entries of a stored report that are used, with their shapes (base.fits()).</extracomment>
        <translation>Bericht des Laufs (JSON)</translation>
    </message>
    <message>
        <source>Distance of each vertex of the envelope from the nearest neighbouring part, for the colours of the envelope</source>
        <translation>Abstand jedes Eckpunkts der Hülle zum nächsten Nachbarteil. Nach diesem Abstand wird die Hülle eingefärbt</translation>
    </message>
    <message>
        <source>Inputs that were deleted (JSON)</source>
        <translation>Eingaben, die gelöscht wurden (JSON)</translation>
    </message>
    <message>
        <source>Parts that were visible in the last run (stored only if AllVisible was true). If one of them changes, the result is stale</source>
        <translation>Teile, die beim letzten Lauf sichtbar waren (nur gespeichert, wenn AllVisible auf True stand). Ändert sich eines davon, ist das Ergebnis veraltet</translation>
    </message>
    <message>
        <source>Record of which face or edge made each triangle (compressed)</source>
        <translation>Aufzeichnung, von welcher Fläche oder Kante jedes Dreieck stammt (komprimiert)</translation>
    </message>
    <message>
        <source>Placement of the result at the time it was stored. If the current placement differs, the result was moved</source>
        <extracomment>Placement of the result when it was stored. It shows whether the result was moved afterwards.</extracomment>
        <translation>Platzierung des Ergebnisses zum Zeitpunkt des Speicherns. Weicht die aktuelle Platzierung davon ab, wurde das Ergebnis verschoben</translation>
    </message>
    <message>
        <source>Solids and meshes that move together. A group or link stands for all the parts in it</source>
        <extracomment>Name in the property -&gt; name in the core.</extracomment>
        <translation>Festkörper und Netze, die sich zusammen bewegen. Eine Gruppe oder Verknüpfung steht für alle Teile darin</translation>
    </message>
    <message>
        <source>Motion of the parts</source>
        <translation>Bewegung der Teile</translation>
    </message>
    <message>
        <source>One motion for each entry of MovingParts, if the parts move independently. Empty: all parts follow Motion</source>
        <translation>Eine Bewegung für jeden Eintrag von MovingParts, wenn sich die Teile unabhängig bewegen. Leer: Alle Teile folgen Motion</translation>
    </message>
    <message>
        <source>Reference part: the envelope is computed as seen from this part, which itself moves. Empty: in the coordinates of the document</source>
        <translation>Bezugsteil: Die Hülle wird relativ zu diesem Teil berechnet, das sich ebenfalls bewegt. Leer: in den Koordinaten des Dokuments</translation>
    </message>
    <message>
        <source>Motion of the reference part</source>
        <translation>Bewegung des Bezugsteils</translation>
    </message>
    <message>
        <source>Largest distance allowed between the computed surface and the true one. It sets the cell size and the tolerance. 0: the cell size comes from CellSize or Resolution, the tolerance from Tolerance</source>
        <translation>Größter erlaubter Abstand zwischen der berechneten und der wahren Fläche. Er bestimmt Zellgröße und Toleranz. 0: Die Zellgröße kommt aus CellSize oder Resolution, die Toleranz aus Tolerance</translation>
    </message>
    <message>
        <source>Edge length of a cell of the grid. 0: computed from Resolution</source>
        <translation>Kantenlänge einer Zelle des Gitters. 0: aus Resolution berechnet</translation>
    </message>
    <message>
        <source>How far the triangle mesh of a solid may deviate from the solid, as a fraction of the cell size</source>
        <translation>Wie weit das Dreiecksnetz eines Festkörpers vom Festkörper abweichen darf, als Bruchteil der Zellgröße</translation>
    </message>
    <message>
        <source>How far simplification may move the surface. 0: no simplification</source>
        <translation>Wie weit die Vereinfachung die Oberfläche verschieben darf. 0: keine Vereinfachung</translation>
    </message>
    <message>
        <source>Distance by which the envelope is grown on all sides</source>
        <translation>Maß, um das die Hülle nach allen Seiten vergrößert wird</translation>
    </message>
    <message>
        <source>True: the envelope provably contains the swept volume</source>
        <translation>True: Die Hülle enthält nachweislich das überstrichene Volumen</translation>
    </message>
    <message>
        <source>True: enclosed cavities are kept as inner shells. False: they are filled</source>
        <translation>True: Eingeschlossene Hohlräume bleiben als innere Schalen. False: Sie werden gefüllt</translation>
    </message>
    <message>
        <source>Poses are skipped as long as no point of the part has moved farther than this length since the last pose used. 0: every pose is used</source>
        <translation>Lagen werden übersprungen, solange sich seit der letzten verwendeten Lage kein Punkt des Teils weiter als diese Länge bewegt hat. 0: Jede Lage wird verwendet</translation>
    </message>
    <message>
        <source>Processor that computes the envelope: CPU, GPU (graphics processor), or Auto, which chooses one of them</source>
        <translation>Prozessor, der die Hülle berechnet: CPU, GPU (Grafikprozessor) oder Auto, das einen davon wählt</translation>
    </message>
    <message>
        <source>Whether to record which face or edge made each triangle. Off: no record. Session: kept until the document is closed. Document: stored in the document, which makes the file larger</source>
        <translation>Ob aufgezeichnet wird, von welcher Fläche oder Kante jedes Dreieck stammt. Off (Aus): keine Aufzeichnung. Session (Sitzung): bleibt, bis das Dokument geschlossen wird. Document (Dokument): wird im Dokument gespeichert, was die Datei größer macht</translation>
    </message>
    <message>
        <source>Volume of the envelope</source>
        <translation>Volumen der Hülle</translation>
    </message>
    <message>
        <source>Surface area of the envelope</source>
        <translation>Flächeninhalt der Hülle</translation>
    </message>
    <message>
        <source>Number of triangles of the envelope</source>
        <translation>Anzahl der Dreiecke der Hülle</translation>
    </message>
    <message>
        <source>Number of separate closed surfaces of the envelope</source>
        <translation>Anzahl der getrennten geschlossenen Oberflächen der Hülle</translation>
    </message>
    <message>
        <source>Number of pairs of triangles that intersect. -1: not counted</source>
        <translation>Anzahl der Paare von Dreiecken, die sich durchdringen. -1: nicht gezählt</translation>
    </message>
    <message>
        <source>Edge length of the grid cells used for this result</source>
        <translation>Kantenlänge der Gitterzellen bei diesem Ergebnis</translation>
    </message>
    <message>
        <source>No point of the surface lies farther than this length from the true surface. 0: not known</source>
        <translation>Kein Punkt der Fläche ist weiter als diese Länge von der wahren Fläche entfernt. 0: nicht bekannt</translation>
    </message>
    <message>
        <source>Duration of the run (s)</source>
        <translation>Dauer des Laufs (s)</translation>
    </message>
    <message>
        <source>Parts that move, in the order of Motions</source>
        <extracomment>Properties that are the same as in the clearance check.</extracomment>
        <translation>Bewegte Teile, in der Reihenfolge von Motions</translation>
    </message>
    <message>
        <source>One motion for each entry of MovingParts. All motions use the same time axis</source>
        <translation>Eine Bewegung für jeden Eintrag von MovingParts. Alle Bewegungen haben dieselbe Zeitachse</translation>
    </message>
    <message>
        <source>True: all other visible parts are neighbours that stand still, and the list Neighbours is not used</source>
        <translation>True: Alle anderen sichtbaren Teile sind stillstehende Nachbarn, und die Liste Neighbours wird nicht verwendet</translation>
    </message>
    <message>
        <source>Pairs of parts that come closer than this length are listed. 0: a tenth of the median size of the parts, or more if a rule needs it</source>
        <translation>Aufgelistet werden Paare von Teilen, deren Abstand kleiner wird als diese Länge. 0: ein Zehntel der mittleren Größe (Median) der Teile, oder mehr, wenn eine Regel es erfordert</translation>
    </message>
    <message>
        <source>Parts or groups of each pair that has its own rule, two entries for each pair: first, second, first, second ...</source>
        <translation>Teile oder Gruppen der Paare, die eine eigene Regel haben; zwei Einträge je Paar: erstes, zweites, erstes, zweites ...</translation>
    </message>
    <message>
        <source>A length (mm) for each pair of RuleParts. Rule Required: the required distance. Rule Contact: the largest depth to which the parts may overlap</source>
        <translation>Eine Länge (mm) für jedes Paar von RuleParts. Regel Required: der Sollabstand. Regel Contact: die größte Tiefe, bis zu der sich die Teile überschneiden dürfen</translation>
    </message>
    <message>
        <source>Number of pairs checked, including pairs that stay farther apart than Range</source>
        <translation>Anzahl der geprüften Paare, einschließlich der Paare, deren Abstand immer größer ist als die Eigenschaft „Range“</translation>
    </message>
    <message>
        <source>Time of each pose (s), in ascending order</source>
        <translation>Zeit jeder Lage (s), aufsteigend</translation>
    </message>
    <message>
        <source>Placement of each pose. PoseType says whether it replaces the placement of the part or is a displacement from it</source>
        <translation>Platzierung jeder Lage. PoseType legt fest, ob sie die Platzierung des Teils ersetzt oder zu ihr hinzukommt (Verschiebung und Drehung)</translation>
    </message>
    <message>
        <source>How the part moves between two poses. Linear: along a straight line, turning at a constant rate. Screw: turning about an axis and moving along it, like a screw. Spline: along a smooth curve through all poses. None: only the poses themselves count, there is no motion between them</source>
        <translation>Wie sich das Teil zwischen zwei Lagen bewegt. Linear: auf einer Geraden, mit gleichmäßiger Drehung. Screw (Schraubung): um eine Achse drehend und an ihr entlang, wie eine Schraube. Spline: auf einer glatten Kurve durch alle Lagen. None (Keine): Nur die Lagen selbst zählen, dazwischen gibt es keine Bewegung</translation>
    </message>
    <message>
        <source>Parts that this motion moves. The motion editor shows the first part</source>
        <translation>Teile, für die diese Bewegung gilt. Der Bewegungseditor zeigt das erste Teil</translation>
    </message>
    <message>
        <source>Other parts that moved too when this motion was recorded from an assembly simulation or a driving value</source>
        <translation>Andere Teile, die sich ebenfalls bewegten, als diese Bewegung aus einer Baugruppensimulation oder einem steuernden Wert aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>Tangent of the spline at each pose. Auto: from the poses before and after. Stop: the part comes to rest. Corner: the direction may change abruptly. Given: the velocity in Velocities. Missing entries count as Auto</source>
        <translation>Tangente des Splines an jeder Lage. Auto (Automatisch): aus den Lagen davor und danach. Stop (Anhalten): Das Teil kommt zur Ruhe. Corner (Ecke): Die Richtung darf sich abrupt ändern. Given (Gegebene Geschwindigkeit): die Geschwindigkeit in Velocities. Fehlende Einträge gelten als Auto</translation>
    </message>
    <message>
        <source>Velocity of the spline (mm/s), one entry for each pose. Used only if the tangent at the pose is Given</source>
        <translation>Geschwindigkeit des Splines (mm/s), ein Eintrag je Lage. Gilt nur, wenn die Tangente an der Lage Given ist</translation>
    </message>
    <message>
        <source>Where the poses come from</source>
        <translation>Woher die Lagen kommen</translation>
    </message>
    <message>
        <source>File from which the poses were read. Reload motion reads it again</source>
        <translation>Datei, aus der die Lagen eingelesen wurden. „Bewegung neu laden“ liest sie erneut ein</translation>
    </message>
    <message>
        <source>Unit of the lengths in the file</source>
        <translation>Einheit der Längen in der Datei</translation>
    </message>
    <message>
        <source>Objects from whose placements or shapes the poses are read</source>
        <translation>Objekte, aus deren Platzierungen oder Formen die Lagen gelesen werden</translation>
    </message>
    <message>
        <source>Settings of the source</source>
        <translation>Einstellungen der Quelle</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>Anzahl der Lagen</translation>
    </message>
    <message>
        <source>Last time minus first time (s)</source>
        <translation>Letzte minus erste Zeit (s)</translation>
    </message>
    <message>
        <source>What is wrong with the motion. Empty: the motion can be used</source>
        <translation>Was an der Bewegung falsch ist. Leer: Die Bewegung kann verwendet werden</translation>
    </message>
    <message>
        <source>Remarks from reading the poses</source>
        <translation>Hinweise beim Lesen der Lagen</translation>
    </message>
    <message>
        <source>Checksum of the source at the time it was read. If the source changes after that, the motion is stale</source>
        <translation>Prüfsumme der Quelle zum Zeitpunkt des Lesens. Ändert sich die Quelle danach, ist die Bewegung veraltet</translation>
    </message>
    <message>
        <source>Number of poses to read. 0 (only for curves): as many poses as SourceAccuracy requires</source>
        <extracomment>Setting of a source (trajectory/sources.py) -&gt; type, name, help and default of its property.</extracomment>
        <translation>Anzahl der zu lesenden Lagen. 0 (nur bei Kurven): so viele Lagen, wie SourceAccuracy erfordert</translation>
    </message>
    <message>
        <source>How far the straight line between two poses may deviate from the curve</source>
        <translation>Wie weit die Gerade zwischen zwei Lagen von der Kurve abweichen darf</translation>
    </message>
    <message>
        <source>Orientation of the part. Fixed: it never turns. Tangent: its x axis follows the tangent. SecondCurve: as Tangent, and its z axis points to the second curve</source>
        <translation>Ausrichtung des Teils. Fixed (Fest): Es dreht sich nie. Tangent (Tangente): Seine x-Achse folgt der Tangente. SecondCurve (Zweite Kurve): wie Tangent, und seine z-Achse zeigt zur zweiten Kurve</translation>
    </message>
    <message>
        <source>Time from the first to the last pose (s)</source>
        <translation>Zeit von der ersten bis zur letzten Lage (s)</translation>
    </message>
    <message>
        <source>Time from one pose to the next (s)</source>
        <translation>Zeit von einer Lage zur nächsten (s)</translation>
    </message>
    <message>
        <source>Speed of rapid moves (G0)</source>
        <translation>Geschwindigkeit der Eilgänge (G0)</translation>
    </message>
    <message>
        <source>What the G-code words A, B and C rotate: the tool head or the table</source>
        <translation>Was die G-Code-Wörter A, B und C drehen: den Werkzeugkopf oder den Tisch</translation>
    </message>
    <message>
        <source>Name of the value that is changed to move the part</source>
        <translation>Name des Werts, der geändert wird, um das Teil zu bewegen</translation>
    </message>
    <message>
        <source>Parts, in the order in which they are installed</source>
        <translation>Teile, in der Reihenfolge ihres Einbaus</translation>
    </message>
    <message>
        <source>One motion for each part. It ends where the part is installed</source>
        <translation>Eine Bewegung für jedes Teil. Sie endet dort, wo das Teil eingebaut ist</translation>
    </message>
    <message>
        <source>Distance that each part must keep from the parts already in place</source>
        <translation>Abstand, den jedes Teil von den schon eingebauten Teilen halten muss</translation>
    </message>
    <message>
        <source>Release distance. At the start or end of its motion, a part may touch another part. This contact may last until some point of the moving part has moved farther than this length</source>
        <translation>Freigabeabstand. Am Start oder Ende seiner Bewegung darf ein Teil ein anderes berühren. Dieser Kontakt darf andauern, bis sich ein Punkt des bewegten Teils weiter als diese Länge bewegt hat</translation>
    </message>
    <message>
        <source>Number of parts that have a path</source>
        <translation>Anzahl der Teile, die eine Bahn haben</translation>
    </message>
    <message>
        <source>First of the two sides that are compared: parts, envelopes or other reserved spaces</source>
        <translation>Erste der beiden Seiten, die verglichen werden: Teile, Hüllen oder andere reservierte Räume</translation>
    </message>
    <message>
        <source>Second of the two sides that are compared: parts, envelopes or other reserved spaces</source>
        <translation>Zweite der beiden Seiten, die verglichen werden: Teile, Hüllen oder andere reservierte Räume</translation>
    </message>
    <message>
        <source>Motion of the first side. Empty: the first side stands still</source>
        <translation>Bewegung der ersten Seite. Leer: Die erste Seite steht still</translation>
    </message>
    <message>
        <source>Motion of the second side. Empty: the second side stands still</source>
        <translation>Bewegung der zweiten Seite. Leer: Die zweite Seite steht still</translation>
    </message>
    <message>
        <source>Time at which both sides are compared (s)</source>
        <translation>Zeit, zu der beide Seiten verglichen werden (s)</translation>
    </message>
    <message>
        <source>How far the triangle mesh of a solid may deviate from the solid</source>
        <translation>Wie weit das Dreiecksnetz eines Festkörpers vom Festkörper abweichen darf</translation>
    </message>
    <message>
        <source>Whether the result is current</source>
        <translation>Ob das Ergebnis aktuell ist</translation>
    </message>
    <message>
        <source>Remarks about the result</source>
        <translation>Hinweise zum Ergebnis</translation>
    </message>
    <message>
        <source>Volume that both sides share</source>
        <translation>Volumen, das beide Seiten gemeinsam haben</translation>
    </message>
    <message>
        <source>Envelope or other closed mesh that is converted to a solid</source>
        <extracomment>Limit of faces of a new solid.</extracomment>
        <translation>Hülle oder anderes geschlossenes Netz, das in einen Festkörper umgewandelt wird</translation>
    </message>
    <message>
        <source>Whether adjacent coplanar triangles are merged into one flat face</source>
        <translation>Ob benachbarte koplanare Dreiecke zu einer ebenen Fläche vereinigt werden</translation>
    </message>
    <message>
        <source>Largest number of faces. If Tolerance is 0 and the exact solid would have more faces, the solid is simplified with the smallest tolerance that is enough</source>
        <translation>Größte Anzahl der Flächen. Ist Tolerance 0 und hätte der genaue Festkörper mehr Flächen, wird er mit der kleinsten Toleranz vereinfacht, die ausreicht</translation>
    </message>
    <message>
        <source>Largest distance of the mesh from the solid, as measured</source>
        <translation>Größter gemessener Abstand des Netzes vom Festkörper</translation>
    </message>
    <message>
        <source>Largest gap between two faces that share an edge</source>
        <translation>Größter Spalt zwischen zwei Flächen mit gemeinsamer Kante</translation>
    </message>
    <message>
        <source>Why the last run failed</source>
        <translation>Warum der letzte Lauf fehlschlug</translation>
    </message>
    <message>
        <source>Faces of the solid</source>
        <translation>Flächen des Festkörpers</translation>
    </message>
    <message>
        <source>Volume of the solid</source>
        <translation>Volumen des Festkörpers</translation>
    </message>
    <message>
        <source>Study file (TOML) that lists the runs. Empty: the runs come from Sources</source>
        <translation>Studiendatei (TOML), die die Läufe auflistet. Leer: Die Läufe kommen aus Sources</translation>
    </message>
    <message>
        <source>Envelopes and clearance checks of this document. Each of them is one run</source>
        <translation>Hüllen und Abstandsprüfungen dieses Dokuments. Jede davon ist ein Lauf</translation>
    </message>
    <message>
        <source>Folder for the results. Empty: the folder set in the study file, or the folder &quot;results&quot; beside that file. Without a study file: a folder beside the document</source>
        <translation>Ordner für die Ergebnisse. Leer: der in der Studiendatei festgelegte Ordner, oder der Ordner „results“ neben ihr. Ohne Studiendatei: ein Ordner neben dem Dokument</translation>
    </message>
    <message>
        <source>Number of runs at the same time. 0: one for each processor core</source>
        <translation>Anzahl gleichzeitiger Läufe. 0: einer je Prozessorkern</translation>
    </message>
    <message>
        <source>Number of runs that have ended</source>
        <extracomment>Properties that are the same as in the clearance check.</extracomment>
        <translation>Anzahl der beendeten Läufe</translation>
    </message>
    <message>
        <source>Folder of the stored result</source>
        <translation>Ordner des gespeicherten Ergebnisses</translation>
    </message>
    <message>
        <source>Study file of the stored result</source>
        <translation>Studiendatei des gespeicherten Ergebnisses</translation>
    </message>
    <message>
        <source>What a pose means.
Absolute: the pose replaces the current placement of the part. This is the default; captured placements and recorded motions use it.
Relative: the pose is added to the current placement of the part. A pose without shift and rotation leaves the part in place.
RelativeToFirst: as Relative, but measured from the first pose. The motion starts at the current placement of the part.
Several parts move together as one rigid body; with Absolute, the poses are those of the first part. A motion in a group (App::Part) uses the coordinates of the group and moves with the group.</source>
        <extracomment>Values of the property PoseType: what a pose means for the part.</extracomment>
        <translation>Was eine Lage bedeutet.
Absolute (Absolut): Die Lage ersetzt die aktuelle Platzierung des Teils. Dies ist die Vorgabe; übernommene Platzierungen und aufgezeichnete Bewegungen verwenden sie.
Relative (Relativ): Die Lage kommt zur aktuellen Platzierung des Teils hinzu. Eine Lage ohne Verschiebung und Drehung lässt das Teil an seinem Platz.
RelativeToFirst (Relativ zur ersten): wie Relative, aber von der ersten Lage aus gemessen. Die Bewegung beginnt an der aktuellen Platzierung des Teils.
Mehrere Teile bewegen sich zusammen wie ein starrer Körper; bei Absolute gelten die Lagen für das erste Teil. Eine Bewegung in einer Gruppe (App::Part) verwendet die Koordinaten der Gruppe und bewegt sich mit ihr.</translation>
    </message>
    <message>
        <source>Largest number of triangles to draw. A larger mesh is reduced to this number on screen. 0: draws all triangles</source>
        <translation>Größte Anzahl der zu zeichnenden Dreiecke. Ein größeres Netz wird auf dem Bildschirm auf diese Anzahl verringert. 0: zeichnet alle Dreiecke</translation>
    </message>
    <message>
        <source>What the colours show. They need a record of the faces that made the envelope: set MadeBy to Session or Document, and compute the envelope again</source>
        <translation>Was die Farben zeigen. Dafür muss aufgezeichnet sein, welche Flächen die Hülle erzeugt haben: Setzen Sie MadeBy auf Session (Sitzung) oder Document (Dokument), und berechnen Sie die Hülle neu</translation>
    </message>
    <message>
        <source>Length of the axes drawn at each pose (mm). 0: chosen automatically</source>
        <translation>Länge der an jeder Lage gezeichneten Achsen (mm). 0: automatisch gewählt</translation>
    </message>
    <message>
        <source>Width of the line that shows the motion (pixels)</source>
        <translation>Breite der Linie, die die Bewegung zeigt (Pixel)</translation>
    </message>
    <message>
        <source>How separate pieces of surface inside one cell are recognised. For research: only Consistent guarantees that the envelope is closed</source>
        <translation>Wie getrennte Flächenstücke innerhalb einer Zelle erkannt werden. Für die Forschung: Nur Consistent (Stimmig) garantiert, dass die Hülle geschlossen ist</translation>
    </message>
    <message>
        <source>Why the last run failed, and its findings</source>
        <translation>Warum der letzte Lauf fehlschlug, und seine Befunde</translation>
    </message>
    <message>
        <source>Smallest distance between the parts, if they share no volume</source>
        <translation>Kleinster Abstand der Teile, wenn sie kein gemeinsames Volumen haben</translation>
    </message>
    <message>
        <source>How deep one of the two parts lies inside the other</source>
        <translation>Wie tief eines der beiden Teile im anderen liegt</translation>
    </message>
    <message>
        <source>Checksum of the inputs of the stored result</source>
        <translation>Prüfsumme der Eingaben des gespeicherten Ergebnisses</translation>
    </message>
    <message>
        <source>Checksum of the inputs of the last failed run</source>
        <translation>Prüfsumme der Eingaben des letzten fehlgeschlagenen Laufs</translation>
    </message>
    <message>
        <source>Number to which the driving value (SourceValue) is set at the first pose, in its own unit (such as mm or degrees)</source>
        <translation>Zahl, auf die der steuernde Wert (SourceValue) bei der ersten Lage gesetzt wird, in dessen eigener Einheit (etwa mm oder Grad)</translation>
    </message>
    <message>
        <source>Number to which the driving value (SourceValue) is set at the last pose, in its own unit (such as mm or degrees)</source>
        <translation>Zahl, auf die der steuernde Wert (SourceValue) bei der letzten Lage gesetzt wird, in dessen eigener Einheit (etwa mm oder Grad)</translation>
    </message>
    <message>
        <source>Point of the part that follows the straight line (Linear) or the curve (Spline) between two poses, and about which the part turns. Coordinates: those of the part if PoseType is Absolute; those of the document, or of the group that holds the motion, if it is Relative; those with the position and orientation of the first pose if it is RelativeToFirst</source>
        <translation>Punkt des Teils, der sich zwischen zwei Lagen auf der Geraden (Linear) oder der Kurve (Spline) bewegt und um den sich das Teil dreht. Koordinaten: die des Teils, wenn PoseType Absolute (Absolut) ist; die des Dokuments, oder der Gruppe, in der die Bewegung liegt, bei Relative (Relativ); die mit Ort und Ausrichtung der ersten Lage bei RelativeToFirst (Relativ zur ersten)</translation>
    </message>
    <message>
        <source>Largest allowed error of the smallest distance. If the motion has the interpolation Spline, or is relative to a moving part, half of this value is subtracted in addition from the guaranteed distance and in the verdict</source>
        <translation>Größter erlaubter Fehler des kleinsten Abstands. Ist die Interpolation der Bewegung Spline, oder ist sie relativ zu einem bewegten Teil, wird die Hälfte dieses Werts zusätzlich vom garantierten Abstand und im Urteil abgezogen</translation>
    </message>
    <message>
        <source>Largest deviation from the mesh to aim at. Not guaranteed: Deviation is the measured value. Within this tolerance, cylinders, spheres and other surfaces are recognised, and the rest is simplified. 0: exact, unless MaxFaces requires a tolerance</source>
        <translation>Wie weit der Festkörper höchstens vom Netz abweichen soll. Nicht garantiert: Deviation ist der gemessene Wert. Innerhalb dieser Toleranz werden Zylinder, Kugeln und andere Flächen erkannt, der Rest wird vereinfacht. 0: genau, sofern MaxFaces keine Toleranz erfordert</translation>
    </message>
    <message>
        <source>Number of cells along the longest side of the box around the swept volume. Used if CellSize is 0</source>
        <translation>Anzahl der Zellen entlang der längsten Seite des Quaders um das überstrichene Volumen. Gilt, wenn CellSize 0 ist</translation>
    </message>
</context>
<context>
    <name>SweptVolume</name>
    <message>
        <source>Check clearance</source>
        <extracomment>The entries of a row in a stored report that are used, with their shapes (base.fits()).
----------
Colours of the bands: clash, contact, below required, clear.</extracomment>
        <translation>Abstand prüfen</translation>
    </message>
    <message>
        <source>Measures the smallest distance between the moving parts and each neighbour over the whole motion. Select an envelope, or parts and a motion, or an existing check</source>
        <translation>Misst den kleinsten Abstand der bewegten Teile von jedem Nachbarn über die ganze Bewegung. Wählen Sie eine Hülle, oder Teile und eine Bewegung, oder eine vorhandene Prüfung</translation>
    </message>
    <message>
        <source>Check mechanism</source>
        <extracomment>The entries of a stored report that are used, with their shapes (base.fits()).
----------
A coloured surface with more triangles than this is simplified for drawing.</extracomment>
        <translation>Mechanismus prüfen</translation>
    </message>
    <message>
        <source>Measures the smallest distance of every pair of parts that move at the same time, over the whole motion. Select their motions, or an existing check. Without a selection, all motions that have parts assigned are checked</source>
        <translation>Misst den kleinsten Abstand jedes Paars von Teilen, die sich gleichzeitig bewegen, über die ganze Bewegung. Wählen Sie ihre Bewegungen oder eine vorhandene Prüfung. Ohne Auswahl werden alle Bewegungen geprüft, denen Teile zugeordnet sind</translation>
    </message>
    <message>
        <source>Check reserved spaces</source>
        <translation>Reservierte Räume prüfen</translation>
    </message>
    <message>
        <source>Measures the distances between envelopes, solids of envelopes, and parts that do not move. If two of them overlap, also measures the volume they share. Select two or more objects. To recompute an existing shared volume, select it</source>
        <translation>Misst die Abstände zwischen Hüllen, Festkörpern von Hüllen und Teilen, die sich nicht bewegen. Überschneiden sich zwei davon, wird auch ihr gemeinsames Volumen gemessen. Wählen Sie zwei oder mehr Objekte aus, oder ein gemeinsames Volumen, um es neu zu berechnen</translation>
    </message>
    <message>
        <source>Create envelope...</source>
        <translation>Hülle erzeugen...</translation>
    </message>
    <message>
        <source>Computes the space that the selected parts occupy during a motion. Select solids or meshes (also inside groups and links) and a motion</source>
        <translation>Berechnet den Raum, den die gewählten Teile während einer Bewegung einnehmen. Wählen Sie Festkörper oder Netze (auch in Gruppen und Verknüpfungen) und eine Bewegung</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Beispiel öffnen</translation>
    </message>
    <message>
        <source>Opens an example: a starter motor is moved past the parts around it into its installed position</source>
        <translation>Öffnet ein Beispiel: Ein Anlasser wird an den Teilen um ihn herum vorbei in seine Einbaulage bewegt</translation>
    </message>
    <message>
        <source>Edit envelope...</source>
        <translation>Hülle bearbeiten...</translation>
    </message>
    <message>
        <source>Changes the parts, motion or settings of the selected envelope</source>
        <translation>Ändert Teile, Bewegung oder Einstellungen der gewählten Hülle</translation>
    </message>
    <message>
        <source>Edit motion...</source>
        <translation>Bewegung bearbeiten …</translation>
    </message>
    <message>
        <source>Edits the keys of the selected motion in a table and in the 3D view, and plays the motion</source>
        <translation>Bearbeitet die Stützstellen der ausgewählten Bewegung in einer Tabelle und in der 3D-Ansicht und spielt die Bewegung ab</translation>
    </message>
    <message>
        <source>Settings of the source...</source>
        <translation>Einstellungen der Quelle...</translation>
    </message>
    <message>
        <source>Changes the settings with which the source of the selected motion is read (such as accuracy, duration or unit), and reads the source again</source>
        <translation>Ändert die Einstellungen, mit denen die Quelle der gewählten Bewegung eingelesen wird (etwa Genauigkeit, Dauer oder Einheit), und liest die Quelle neu ein</translation>
    </message>
    <message>
        <source>Export envelope...</source>
        <translation>Hülle exportieren...</translation>
    </message>
    <message>
        <source>Writes the selected envelope as STEP, BREP, STL, PLY, OBJ, OFF or 3MF and checks the file. You can also select a solid that was made from an envelope: the panel then begins with the settings of this solid</source>
        <translation>Schreibt die gewählte Hülle als STEP, BREP, STL, PLY, OBJ, OFF oder 3MF und prüft die Datei. Sie können auch einen Festkörper wählen, der aus einer Hülle erzeugt wurde: Das Panel beginnt dann mit den Einstellungen dieses Festkörpers</translation>
    </message>
    <message>
        <source>Export report...</source>
        <translation>Bericht exportieren...</translation>
    </message>
    <message>
        <source>Writes the results of the selected check or study as one HTML file or as PDF. The HTML file of a check has a 3D view</source>
        <translation>Schreibt die Ergebnisse der gewählten Prüfung oder Studie als eine HTML-Datei oder als PDF. Die HTML-Datei einer Prüfung enthält eine 3D-Ansicht</translation>
    </message>
    <message>
        <source>Find path...</source>
        <translation>Bahn finden...</translation>
    </message>
    <message>
        <source>Finds a path on which the selected part reaches its installed position and keeps a distance from its neighbours. Select the part first, then its neighbours. A selected motion sets the start and the goal</source>
        <translation>Findet eine Bahn, auf der das gewählte Teil seine Einbaulage erreicht und Abstand zu seinen Nachbarn hält. Wählen Sie zuerst das Teil, dann seine Nachbarn. Eine gewählte Bewegung legt Start und Ziel fest</translation>
    </message>
    <message>
        <source>Improve path...</source>
        <translation>Bahn verbessern...</translation>
    </message>
    <message>
        <source>Removes clashes from the selected motion, makes it shorter with fewer keys, or increases its clearance. The result is a new motion; the selected one is kept</source>
        <translation>Beseitigt Kollisionen der ausgewählten Bewegung, macht sie kürzer mit weniger Stützstellen oder vergrößert ihren Abstand. Das Ergebnis ist eine neue Bewegung; die ausgewählte bleibt</translation>
    </message>
    <message>
        <source>Install the core</source>
        <extracomment>The open dialog, or None.</extracomment>
        <translation>Rechenkern installieren</translation>
    </message>
    <message>
        <source>Installs the core, the compiled package that does the computation</source>
        <translation>Installiert den Rechenkern, das kompilierte Paket, das die Berechnungen ausführt</translation>
    </message>
    <message>
        <source>What made this?</source>
        <translation>Was hat das erzeugt?</translation>
    </message>
    <message>
        <source>Colours the selected envelope by the faces that made it. Click on the envelope to see which part passed there, with which face or edge, and when</source>
        <translation>Färbt die gewählte Hülle nach den Flächen, die sie erzeugt haben. Ein Klick auf die Hülle zeigt, welches Teil dort mit welcher Fläche oder Kante vorbeikam, und wann</translation>
    </message>
    <message>
        <source>Make solid</source>
        <translation>Festkörper erzeugen</translation>
    </message>
    <message>
        <source>Converts the selected envelope to a solid for Boolean operations, measuring and STEP. A selected solid is converted again</source>
        <translation>Wandelt die ausgewählte Hülle in einen Festkörper für boolesche Operationen, Messen und STEP um. Ein ausgewählter Festkörper wird neu erzeugt</translation>
    </message>
    <message>
        <source>Motion from driving value...</source>
        <translation>Bewegung aus steuerndem Wert...</translation>
    </message>
    <message>
        <source>Changes a value (a spreadsheet cell, a sketch dimension or a variable of an assembly) and records how a part moves with it. Select the object with the value, then the part. If no part is selected, every part that moves gets a motion</source>
        <translation>Ändert einen Wert (eine Tabellenzelle, ein Skizzenmaß oder eine Variable einer Baugruppe) und zeichnet auf, wie sich ein Teil damit bewegt. Wählen Sie das Objekt mit dem Wert, dann das Teil. Ist kein Teil gewählt, erhält jedes Teil, das sich bewegt, eine Bewegung</translation>
    </message>
    <message>
        <source>Motion from file...</source>
        <translation>Bewegung aus Datei...</translation>
    </message>
    <message>
        <source>Reads a motion from a CSV file. Each row holds time, position and quaternion (t,tx,ty,tz,qx,qy,qz,qw), or the 16 numbers of a matrix</source>
        <translation>Liest eine Bewegung aus einer CSV-Datei. Jede Zeile enthält Zeit, Position und Quaternion (t,tx,ty,tz,qx,qy,qz,qw) oder die 16 Zahlen einer Matrix</translation>
    </message>
    <message>
        <source>Motion from selected placements</source>
        <translation>Bewegung aus ausgewählten Platzierungen</translation>
    </message>
    <message>
        <source>Makes a motion from the placements of the selected objects, in the order of selection. The motion stays linked to the objects: if you move an object, its pose changes too</source>
        <translation>Erzeugt eine Bewegung aus den Platzierungen der gewählten Objekte, in der Reihenfolge der Auswahl. Die Bewegung bleibt mit den Objekten verknüpft: Wenn Sie ein Objekt verschieben, ändert sich die zugehörige Lage der Bewegung</translation>
    </message>
    <message>
        <source>Motion from object...</source>
        <translation>Bewegung aus Objekt...</translation>
    </message>
    <message>
        <source>Makes a motion from the selected wire, sketch, robot trajectory, link array, Draft array, CAM operation or assembly simulation. If you select a second curve, it sets the orientation. The motion stays linked to its source</source>
        <translation>Erzeugt eine Bewegung aus der Auswahl: Linienzug, Skizze, Roboterbahn, Link-Anordnung, Draft-Anordnung, CAM-Operation oder Baugruppensimulation. Wenn Sie eine zweite Kurve wählen, bestimmt sie die Ausrichtung. Die Bewegung bleibt mit ihrer Quelle verknüpft</translation>
    </message>
    <message>
        <source>New motion...</source>
        <translation>Neue Bewegung...</translation>
    </message>
    <message>
        <source>Opens the motion editor: move the selected part step by step and capture its placements</source>
        <translation>Öffnet den Bewegungseditor: Bewegen Sie das ausgewählte Teil Schritt für Schritt, und übernehmen Sie seine Platzierungen</translation>
    </message>
    <message>
        <source>Recompute envelope</source>
        <translation>Hülle neu berechnen</translation>
    </message>
    <message>
        <source>Reload motion</source>
        <translation>Bewegung neu laden</translation>
    </message>
    <message>
        <source>Reads the file or source of the selected motion again. All motions of the same driving value or simulation are read together</source>
        <translation>Liest die Datei oder Quelle der gewählten Bewegung neu ein. Alle Bewegungen, die aus demselben steuernden Wert oder derselben Simulation stammen, werden zusammen eingelesen</translation>
    </message>
    <message>
        <source>Sequence...</source>
        <extracomment>the line is visible.</extracomment>
        <translation>Einbaufolge...</translation>
    </message>
    <message>
        <source>Finds installation paths for the selected parts, one after the other. Each part keeps its distance from the parts already in place. You give the order, or the search finds one. If a sequence is selected, it is opened</source>
        <translation>Findet Einbaubahnen für die gewählten Teile, eines nach dem anderen. Jedes Teil hält Abstand zu den Teilen, die schon eingebaut sind. Die Reihenfolge können Sie vorgeben oder von der Suche bestimmen lassen. Ist eine Einbaufolge gewählt, wird sie geöffnet</translation>
    </message>
    <message>
        <source>Study...</source>
        <translation>Studie...</translation>
    </message>
    <message>
        <source>Runs many computations, several at once. The runs come from a study file, or are envelopes and clearance checks of the document. Select envelopes and checks, or an existing study</source>
        <translation>Führt viele Berechnungen aus, mehrere gleichzeitig. Die Läufe kommen aus einer Studiendatei oder sind Hüllen und Abstandsprüfungen des Dokuments. Wählen Sie Hüllen und Prüfungen aus, oder eine vorhandene Studie</translation>
    </message>
    <message>
        <source>Keyboard to the tree or panel</source>
        <translation>Tastatur zum Baum oder Panel</translation>
    </message>
    <message>
        <source>Moves the keyboard focus to the tree. There the arrow keys select; Ctrl with the arrow keys and Space selects more objects. If the focus is in the tree, moves it to the open panel</source>
        <translation>Setzt den Tastaturfokus in den Baum. Dort wählen die Pfeiltasten aus; Strg mit Pfeiltasten und Leertaste wählt weitere Objekte. Ist der Fokus im Baum, springt er in das offene Panel</translation>
    </message>
    <message>
        <source>Improve path</source>
        <translation>Bahn verbessern</translation>
    </message>
    <message>
        <source>Find path</source>
        <extracomment>Interval (ms) between two checks of the search&apos;s progress.</extracomment>
        <translation>Bahn finden</translation>
    </message>
    <message>
        <source>Sequence</source>
        <extracomment>The panel opened last, for tests and macros. FreeCAD does not give access to it.</extracomment>
        <translation>Einbaufolge</translation>
    </message>
    <message>
        <source>Edit envelope</source>
        <translation>Hülle bearbeiten</translation>
    </message>
    <message>
        <source>Export envelope</source>
        <extracomment>Parameter group in which FreeCAD keeps the folder of the last file.
----------
The panel opened last, for tests and macros. FreeCAD does not give access to it.</extracomment>
        <translation>Hülle exportieren</translation>
    </message>
    <message>
        <source>Edit motion</source>
        <translation>Bewegung bearbeiten</translation>
    </message>
    <message>
        <source>Settings of the source</source>
        <translation>Einstellungen der Quelle</translation>
    </message>
    <message>
        <source>Create envelope</source>
        <translation>Hülle erzeugen</translation>
    </message>
    <message>
        <source>Compute again</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>Make solid again</source>
        <translation>Festkörper neu erzeugen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>The part has no surface: choose a solid or a mesh with triangles.</source>
        <extracomment>Maps a code to a text that says what happened and what to do.</extracomment>
        <translation>Das Teil hat keine Oberfläche: Wählen Sie einen Festkörper oder ein Netz mit Dreiecken.</translation>
    </message>
    <message>
        <source>Some vertices of the mesh have coordinates that are not finite numbers: repair the mesh, or export it again.</source>
        <translation>Einige Eckpunkte des Netzes haben Koordinaten, die keine endlichen Zahlen sind: Reparieren Sie das Netz, oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>The part encloses no volume: choose a solid or a closed mesh.</source>
        <translation>Das Teil umschließt keinen Raum: Wählen Sie einen Festkörper oder ein geschlossenes Netz.</translation>
    </message>
    <message>
        <source>The part is so far from the origin that its coordinates are not exact enough: move the part and its motion closer to the origin.</source>
        <translation>Das Teil liegt so weit vom Ursprung, dass seine Koordinaten nicht genau genug sind: Verschieben Sie Teil und Bewegung näher an den Ursprung.</translation>
    </message>
    <message>
        <source>The part or the motion reaches more than 1e9 mm from the origin: check the unit of length.</source>
        <translation>Das Teil oder die Bewegung reicht weiter als 1e9 mm vom Ursprung: Prüfen Sie die Längeneinheit.</translation>
    </message>
    <message>
        <source>A setting is not allowed: correct it. The details in parentheses name the setting and say what is allowed.</source>
        <translation>Eine Einstellung ist nicht erlaubt: Berichtigen Sie sie. Die Angaben in Klammern nennen die Einstellung und sagen, was erlaubt ist.</translation>
    </message>
    <message>
        <source>The motion has no poses: add at least one.</source>
        <translation>Die Bewegung hat keine Lagen: Fügen Sie mindestens eine hinzu.</translation>
    </message>
    <message>
        <source>A pose scales, shears or mirrors the part: use poses that only rotate and translate.</source>
        <translation>Eine Lage skaliert, schert oder spiegelt das Teil: Verwenden Sie Lagen, die nur drehen und verschieben.</translation>
    </message>
    <message>
        <source>A pose cannot be used: all its numbers must be finite, and the times must not decrease.</source>
        <translation>Eine Lage kann nicht verwendet werden: Alle ihre Zahlen müssen endlich sein, und die Zeiten dürfen nicht abnehmen.</translation>
    </message>
    <message>
        <source>The part turns by 180 degrees, or nearly so, between two poses, so the direction of the turn is ambiguous: add a pose between them. The details in parentheses name the poses.</source>
        <translation>Das Teil dreht sich zwischen zwei Lagen um 180 Grad oder fast so weit, daher ist die Drehrichtung nicht eindeutig: Fügen Sie eine Lage dazwischen ein. Die Angaben in Klammern nennen die Lagen.</translation>
    </message>
    <message>
        <source>Two parts are closer than the required distance in their installed positions: reduce the required distance, or set a release distance, which allows contact near the installed positions. The details in parentheses name the parts.</source>
        <translation>Zwei Teile sind in ihren Einbaulagen näher beieinander als der Sollabstand: Verringern Sie den Sollabstand, oder geben Sie einen Freigabeabstand an, der Kontakt in der Nähe der Einbaulagen erlaubt. Die Angaben in Klammern nennen die Teile.</translation>
    </message>
    <message>
        <source>The file cannot be read: the details in parentheses say where and why.</source>
        <translation>Die Datei kann nicht gelesen werden: Die Angaben in Klammern nennen Stelle und Ursache.</translation>
    </message>
    <message>
        <source>The file extension is not supported: choose another one. The details in parentheses list the supported ones.</source>
        <translation>Die Dateiendung wird nicht unterstützt: Wählen Sie eine andere. Die Angaben in Klammern nennen die unterstützten Endungen.</translation>
    </message>
    <message>
        <source>The file is larger than the limit for input files: split it, or reduce it.</source>
        <translation>Die Datei ist größer als die Grenze für Eingabedateien: Teilen oder verkleinern Sie sie.</translation>
    </message>
    <message>
        <source>The computation exceeds a limit, usually the memory limit: choose a larger cell, or raise the limit in the preferences.</source>
        <translation>Die Berechnung überschreitet eine Grenze, meist die Speichergrenze: Wählen Sie eine größere Zelle, oder erhöhen Sie die Grenze in den Einstellungen.</translation>
    </message>
    <message>
        <source>The result would have too many triangles: choose a larger cell or a lower resolution.</source>
        <translation>Das Ergebnis hätte zu viele Dreiecke: Wählen Sie eine größere Zelle oder eine geringere Auflösung.</translation>
    </message>
    <message>
        <source>The solid would have too many faces: set a larger tolerance, or export a mesh file.</source>
        <translation>Der Festkörper hätte zu viele Flächen: Geben Sie eine größere Toleranz an, oder exportieren Sie eine Netzdatei.</translation>
    </message>
    <message>
        <source>The computer ran out of memory: choose a larger cell or a lower resolution.</source>
        <translation>Dem Rechner ging der Speicher aus: Wählen Sie eine größere Zelle oder eine geringere Auflösung.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>There is no neighbour to check: choose at least one part as a neighbour.</source>
        <translation>Es gibt keinen Nachbarn, der geprüft werden kann: Wählen Sie mindestens ein Teil als Nachbarn.</translation>
    </message>
    <message>
        <source>A rule cannot be applied: correct the rule, or remove it. The details in parentheses name the rule.</source>
        <translation>Eine Regel ist nicht anwendbar: Berichtigen oder entfernen Sie sie. Die Angaben in Klammern nennen die Regel.</translation>
    </message>
    <message>
        <source>The report template has an error: correct the template. The details in parentheses name the line.</source>
        <translation>Die Berichtsvorlage hat einen Fehler: Berichtigen Sie die Vorlage. Die Angaben in Klammern nennen die Zeile.</translation>
    </message>
    <message>
        <source>At the goal, the part is too close to a neighbour, or overlaps it: move the neighbour, reduce the required distance, or set a release distance, which allows contact near the goal. The details in parentheses name the neighbour.</source>
        <translation>Am Ziel ist das Teil zu nah an einem Nachbarn oder überschneidet sich mit ihm: Verschieben Sie den Nachbarn, verringern Sie den Sollabstand, oder geben Sie einen Freigabeabstand an, der Kontakt in der Nähe des Ziels erlaubt. Die Angaben in Klammern nennen den Nachbarn.</translation>
    </message>
    <message>
        <source>At the start, the part is too close to a neighbour, or overlaps it: move the neighbour, reduce the required distance, or set a release distance, which allows contact near the start. The details in parentheses name the neighbour.</source>
        <translation>Am Start ist das Teil zu nah an einem Nachbarn oder überschneidet sich mit ihm: Verschieben Sie den Nachbarn, verringern Sie den Sollabstand, oder geben Sie einen Freigabeabstand an, der Kontakt in der Nähe des Starts erlaubt. Die Angaben in Klammern nennen den Nachbarn.</translation>
    </message>
    <message>
        <source>Start and goal are the same: choose another start or goal.</source>
        <translation>Start und Ziel sind gleich: Wählen Sie einen anderen Start oder ein anderes Ziel.</translation>
    </message>
    <message>
        <source>No start is given: enter a placement, a distance or a direction.</source>
        <translation>Es ist kein Start angegeben: Geben Sie eine Platzierung, eine Entfernung oder eine Richtung ein.</translation>
    </message>
    <message>
        <source>The file could not be written: check the folder, its permissions and the free disk space.</source>
        <translation>Die Datei konnte nicht geschrieben werden: Prüfen Sie den Ordner, seine Zugriffsrechte und den freien Speicherplatz.</translation>
    </message>
    <message>
        <source>OpenCASCADE could not build the solid: set a larger Tolerance for the solid, or export a mesh file (STL, PLY).</source>
        <translation>OpenCASCADE konnte den Festkörper nicht erzeugen: Geben Sie eine größere Toleranz für den Festkörper an, oder exportieren Sie eine Netzdatei (STL, PLY).</translation>
    </message>
    <message>
        <source>No usable GPU (graphics processor) was found: set Backend to CPU.</source>
        <translation>Es wurde keine verwendbare GPU (Grafikprozessor) gefunden: Setzen Sie „Rechenwerk“ auf „CPU“.</translation>
    </message>
    <message>
        <source>The GPU (graphics processor) failed during the computation: set Backend to CPU.</source>
        <translation>Die GPU (Grafikprozessor) ist während der Berechnung ausgefallen: Setzen Sie „Rechenwerk“ auf „CPU“.</translation>
    </message>
    <message>
        <source>The solids of a part overlap one another: select each solid on its own, or fuse them first. The details in parentheses name the part.</source>
        <translation>Die Festkörper eines Teils überschneiden sich: Wählen Sie jeden einzeln, oder vereinigen Sie sie vorher. Die Angaben in Klammern nennen das Teil.</translation>
    </message>
    <message>
        <source>The shared volume of two parts could not be computed: repair their meshes, or move one part slightly. The details in parentheses name the parts and the cause.</source>
        <translation>Das gemeinsame Volumen zweier Teile konnte nicht berechnet werden: Reparieren Sie ihre Netze, oder verschieben Sie ein Teil etwas. Die Angaben in Klammern nennen die Teile und die Ursache.</translation>
    </message>
    <message>
        <source>Triangles with zero area were removed.</source>
        <translation>Dreiecke ohne Fläche wurden entfernt.</translation>
    </message>
    <message>
        <source>Duplicate triangles were removed.</source>
        <translation>Doppelte Dreiecke wurden entfernt.</translation>
    </message>
    <message>
        <source>Pairs of triangles with the same corners but opposite directions were removed.</source>
        <translation>Paare von Dreiecken mit denselben Ecken, aber entgegengesetzter Richtung wurden entfernt.</translation>
    </message>
    <message>
        <source>The depth of an allowed contact was measured, but the parts may overlap more deeply at another point.</source>
        <translation>Die Tiefe eines erlaubten Kontakts wurde gemessen, aber die Teile könnten sich an einer anderen Stelle tiefer überschneiden.</translation>
    </message>
    <message>
        <source>Some adjacent triangles face opposite ways: check the mesh if the result looks wrong.</source>
        <translation>Die Normalen einiger benachbarter Dreiecke zeigen in entgegengesetzte Richtungen: Prüfen Sie das Netz, falls das Ergebnis falsch aussieht.</translation>
    </message>
    <message>
        <source>The surface of the part has only one side, like a Möbius strip: repair the mesh.</source>
        <translation>Die Oberfläche des Teils hat nur eine Seite, wie ein Möbiusband: Reparieren Sie das Netz.</translation>
    </message>
    <message>
        <source>More than two triangles meet at some edges of the part: repair the mesh if the result looks wrong.</source>
        <translation>An manchen Kanten des Teils treffen sich mehr als zwei Dreiecke: Reparieren Sie das Netz, falls das Ergebnis falsch aussieht.</translation>
    </message>
    <message>
        <source>The part intersects itself, and some of its regions face inwards: repair the mesh.</source>
        <translation>Das Teil durchdringt sich selbst, und einige seiner Bereiche zeigen nach innen: Reparieren Sie das Netz.</translation>
    </message>
    <message>
        <source>The part has cavities. They change the envelope only if Keep cavities is ticked.</source>
        <translation>Das Teil hat Hohlräume. Diese wirken sich nur dann auf die Hülle aus, wenn „Hohlräume behalten“ eingeschaltet ist.</translation>
    </message>
    <message>
        <source>Poses with the same placement as the pose before were left out.</source>
        <translation>Lagen mit derselben Platzierung wie die vorige Lage wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The rotations of some poses had small rounding errors, which were corrected.</source>
        <translation>Die Drehungen einiger Lagen hatten kleine Rundungsfehler, die berichtigt wurden.</translation>
    </message>
    <message>
        <source>Some triangles of the envelope intersect. If you need a solid, change the cell size slightly.</source>
        <translation>Manche Dreiecke der Hülle durchdringen sich. Wenn Sie einen Festkörper brauchen, ändern Sie die Zellgröße etwas.</translation>
    </message>
    <message>
        <source>The envelope was not simplified: the details in parentheses say why.</source>
        <translation>Die Hülle wurde nicht vereinfacht: Die Angaben in Klammern nennen die Ursache.</translation>
    </message>
    <message>
        <source>The envelope is correct, but its simplification stopped early: it has more triangles than the tolerance requires.</source>
        <translation>Die Hülle ist richtig, aber ihre Vereinfachung endete vorzeitig: Sie hat mehr Dreiecke, als die Toleranz erfordert.</translation>
    </message>
    <message>
        <source>This surface is a preview. It was not checked for errors such as intersecting triangles.</source>
        <translation>Diese Oberfläche ist eine Vorschau. Sie wurde nicht auf Fehler wie sich durchdringende Dreiecke geprüft.</translation>
    </message>
    <message>
        <source>Open a document first.</source>
        <translation>Öffnen Sie zuerst ein Dokument.</translation>
    </message>
    <message>
        <source>This motion was not read from a source, so there are no settings to change.</source>
        <translation>Diese Bewegung wurde nicht aus einer Quelle gelesen, daher gibt es keine Einstellungen zu ändern.</translation>
    </message>
    <message>
        <source>There is no check in the document: make one with Check clearance or Check mechanism.</source>
        <translation>Im Dokument gibt es keine Prüfung: Legen Sie eine mit „Abstand prüfen“ oder „Mechanismus prüfen“ an.</translation>
    </message>
    <message>
        <source>The document has {0} checks and studies: select one of them.</source>
        <translation>Das Dokument enthält {0} Prüfungen und Studien: Wählen Sie eine davon aus.</translation>
    </message>
    <message>
        <source>Select the part for which to find a path.</source>
        <translation>Wählen Sie das Teil aus, für das eine Bahn gesucht werden soll.</translation>
    </message>
    <message>
        <source>The motion &quot;{0}&quot; does not say which part it moves: select the part together with the motion.</source>
        <translation>Die Bewegung „{0}“ gibt nicht an, welches Teil sie bewegt: Wählen Sie das Teil zusammen mit der Bewegung aus.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has fewer than two keys, so there is no path to improve: add a key.</source>
        <translation>„{0}“ hat weniger als zwei Stützstellen, es gibt also keine Bahn zu verbessern: Fügen Sie eine Stützstelle hinzu.</translation>
    </message>
    <message>
        <source>Select the object with the value that drives the motion, then the part that moves.</source>
        <translation>Wählen Sie das Objekt mit dem Wert, der die Bewegung steuert, dann das Teil, das sich bewegt.</translation>
    </message>
    <message>
        <source>Select the object with the value to change (a spreadsheet, a sketch or variables), then the part that moves with the value.</source>
        <translation>Wählen Sie das Objekt mit dem Wert, der geändert wird (Tabelle, Skizze oder Variablen), dann das Teil, das sich mit dem Wert bewegt.</translation>
    </message>
    <message>
        <source>Select at least two objects: their placements become the poses.</source>
        <translation>Wählen Sie mindestens zwei Objekte aus: Die Platzierungen dieser Objekte werden zu den Lagen.</translation>
    </message>
    <message>
        <source>Select at least two objects in the order of the motion: their placements become the poses. Use copies or links of the part, or local coordinate systems.</source>
        <translation>Wählen Sie mindestens zwei Objekte in der Reihenfolge der Bewegung aus: Die Platzierungen dieser Objekte werden zu den Lagen. Verwenden Sie Kopien oder Verknüpfungen des Teils oder lokale Koordinatensysteme.</translation>
    </message>
    <message>
        <source>Select a wire, sketch, array, CAM operation or robot trajectory; or an assembly simulation and the part whose motion you want.</source>
        <translation>Wählen Sie einen Linienzug, eine Skizze, Anordnung, CAM-Operation oder Roboterbahn aus; oder eine Baugruppensimulation und das Teil, dessen Bewegung Sie brauchen.</translation>
    </message>
    <message>
        <source>Select one wire, sketch, robot trajectory, link array, Draft array or CAM operation; or two curves; or an assembly simulation and the part whose motion you want.</source>
        <translation>Wählen Sie einen Linienzug, eine Skizze, Roboterbahn, Link-Anordnung, Draft-Anordnung oder CAM-Operation; oder zwei Kurven; oder eine Baugruppensimulation und das Teil, dessen Bewegung Sie brauchen.</translation>
    </message>
    <message>
        <source>No moving part is chosen: select a solid or a mesh, then press Add selected.</source>
        <translation>Es ist kein bewegtes Teil gewählt: Wählen Sie einen Festkörper oder ein Netz aus, und klicken Sie auf „Auswahl hinzufügen“.</translation>
    </message>
    <message>
        <source>The link &quot;{0}&quot; is empty: its target was deleted, or the document of the target is not open. Open that document, or choose another target.</source>
        <translation>Die Verknüpfung „{0}“ ist leer: Das verknüpfte Objekt wurde gelöscht, oder sein Dokument ist nicht geöffnet. Öffnen Sie dieses Dokument, oder verknüpfen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; contains neither a solid nor a mesh: choose another object.</source>
        <translation>„{0}“ enthält weder Festkörper noch Netz: Wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>The moving part has no faces: choose a part with a shape or a mesh.</source>
        <translation>Das bewegte Teil hat keine Flächen: Wählen Sie ein Teil mit einer Form oder einem Netz.</translation>
    </message>
    <message>
        <source>The shape could not be turned into triangles: check it with Part &gt; Check geometry.</source>
        <extracomment>Angular deflection of meshed solids (rad). The linear deflection depends on the cell.</extracomment>
        <translation>Die Form konnte nicht in Dreiecke zerlegt werden: Prüfen Sie sie mit „Part &gt; Geometrie überprüfen“.</translation>
    </message>
    <message>
        <source>The shape has {0} faces but no solid: make it a solid with Part &gt; Convert to solid or Part &gt; Shape builder, or choose a closed mesh.</source>
        <translation>Die Form hat {0} Flächen, aber keinen Festkörper: Wandeln Sie sie mit „Part &gt; In Festkörper umwandeln“ oder „Part &gt; Form-Generator“ in einen Festkörper um, oder wählen Sie ein geschlossenes Netz.</translation>
    </message>
    <message>
        <source>The document has no object &quot;{0}&quot; any more: choose the part again.</source>
        <translation>Das Dokument hat kein Objekt „{0}“ mehr: Wählen Sie das Teil neu.</translation>
    </message>
    <message>
        <source>The interpreter {0} has no pip. Install pip (on Debian and Ubuntu: the package python3-pip), or choose another interpreter in the preferences of the Addon Manager.</source>
        <translation>Der Interpreter {0} hat kein pip. Installieren Sie pip (in Debian und Ubuntu das Paket python3-pip), oder wählen Sie in den Einstellungen des Addon-Managers einen anderen Interpreter.</translation>
    </message>
    <message>
        <source>The package index could not be reached: check the network connection, or choose a package file (.whl) with the button &quot;From a file&quot;. pip says:
{0}</source>
        <translation>Der Paketindex ist nicht erreichbar: Prüfen Sie die Netzwerkverbindung, oder wählen Sie mit der Schaltfläche „Aus einer Datei“ eine Paketdatei (.whl). pip meldet:
{0}</translation>
    </message>
    <message>
        <source>There is no core of version {0} for Python {1} and this operating system: choose a package file (.whl) with the button &quot;From a file&quot;, or build the core as described in docs/handbook/installation.md. pip says:
{2}</source>
        <translation>Es gibt keinen Rechenkern der Version {0} für Python {1} und dieses Betriebssystem: Wählen Sie mit der Schaltfläche „Aus einer Datei“ eine Paketdatei (.whl), oder kompilieren Sie den Rechenkern, wie in docs/handbook/installation.md beschrieben. pip meldet:
{2}</translation>
    </message>
    <message>
        <source>The file &quot;{0}&quot; is not the core of Swept Volume: choose a file whose name begins with swept_volume.</source>
        <translation>Die Datei „{0}“ ist nicht der Rechenkern von Swept Volume: Wählen Sie eine Datei, deren Name mit swept_volume beginnt.</translation>
    </message>
    <message>
        <source>The core in &quot;{0}&quot; has version {1}, but the workbench has version {2}: choose a core of version {2}.</source>
        <translation>Der Rechenkern in „{0}“ hat Version {1}, der Arbeitsbereich aber Version {2}: Wählen Sie einen Rechenkern der Version {2}.</translation>
    </message>
    <message>
        <source>No Python interpreter was found to run pip: install Python.</source>
        <extracomment>Where the Addon Manager keeps the interpreter that the user has chosen for pip.</extracomment>
        <translation>Es wurde kein Python-Interpreter gefunden, der pip ausführen kann: Installieren Sie Python.</translation>
    </message>
    <message>
        <source>pip could not install the core: choose a package file (.whl) with the button &quot;From a file&quot;, or build the core as described in docs/handbook/installation.md. pip says:
{0}</source>
        <translation>pip konnte den Rechenkern nicht installieren: Wählen Sie mit der Schaltfläche „Aus einer Datei“ eine Paketdatei (.whl), oder kompilieren Sie den Rechenkern, wie in docs/handbook/installation.md beschrieben. pip meldet:
{0}</translation>
    </message>
    <message>
        <source>The file &quot;{0}&quot; cannot be read as a Python package ({1}): choose another file.</source>
        <translation>Die Datei „{0}“ kann nicht als Python-Paket gelesen werden ({1}): Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>The core was not installed: {0}</source>
        <translation>Der Rechenkern wurde nicht installiert: {0}</translation>
    </message>
    <message>
        <source>The core is not published on {0} yet: choose a package file (.whl) with the button &quot;From a file&quot;, or build the core as described in docs/handbook/installation.md.</source>
        <translation>Der Rechenkern ist auf {0} noch nicht veröffentlicht: Wählen Sie mit der Schaltfläche „Aus einer Datei“ eine Paketdatei (.whl), oder kompilieren Sie den Rechenkern, wie in docs/handbook/installation.md beschrieben.</translation>
    </message>
    <message>
        <source>pip ended without an error, but installed no usable core: choose another package file (.whl) with the button &quot;From a file&quot;, or build the core as described in docs/handbook/installation.md.</source>
        <translation>pip wurde ohne Fehler beendet, hat aber keinen brauchbaren Rechenkern installiert: Wählen Sie mit der Schaltfläche „Aus einer Datei“ eine andere Paketdatei (.whl), oder kompilieren Sie den Rechenkern, wie in docs/handbook/installation.md beschrieben.</translation>
    </message>
    <message>
        <source>The compiled core of Swept Volume (_swept, for Python {0}) cannot be loaded.
Choose Swept Volume &gt; Install the core, or build the core in the folder {1}:
    cmake --preset release &amp;&amp; cmake --build build
.ci/packages.txt lists the packages that the build needs. If the core is elsewhere, set the environment variable SWEPT_CORE to its folder.
FreeCAD looked for the core in:
  {2}</source>
        <extracomment>its longest side when it is simplified.</extracomment>
        <translation>Der kompilierte Rechenkern von Swept Volume (_swept, für Python {0}) kann nicht geladen werden.
Wählen Sie „Überstrichener Raum &gt; Rechenkern installieren“, oder kompilieren Sie ihn im Ordner {1}:
    cmake --preset release &amp;&amp; cmake --build build
.ci/packages.txt nennt die Pakete, die dafür nötig sind. Liegt der Rechenkern anderswo, setzen Sie die Umgebungsvariable SWEPT_CORE auf seinen Ordner.
FreeCAD hat den Rechenkern hier gesucht:
  {2}</translation>
    </message>
    <message>
        <source>The compiled core of Swept Volume in {0} has version {1}, but the workbench has version {2}. Choose Swept Volume &gt; Install the core, or build the core again in the folder {3}:
    cmake --preset release &amp;&amp; cmake --build build</source>
        <translation>Der kompilierte Rechenkern von Swept Volume in {0} hat Version {1}, der Arbeitsbereich aber Version {2}. Wählen Sie Überstrichener Raum &gt; Rechenkern installieren, oder kompilieren Sie den Rechenkern im Ordner {3} neu:
    cmake --preset release &amp;&amp; cmake --build build</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Installation path</source>
        <translation>Einbaubahn</translation>
    </message>
    <message>
        <source>Demo</source>
        <extracomment>Largest deviation by simplification (mm).</extracomment>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>Starter motor</source>
        <extracomment>Name, label, function, colour of each part. The first part moves.</extracomment>
        <translation>Anlasser</translation>
    </message>
    <message>
        <source>Bell housing</source>
        <translation>Getriebeglocke</translation>
    </message>
    <message>
        <source>Flywheel</source>
        <translation>Schwungrad</translation>
    </message>
    <message>
        <source>Engine block and pan</source>
        <translation>Motorblock und Wanne</translation>
    </message>
    <message>
        <source>Exhaust pipe</source>
        <translation>Auspuffrohr</translation>
    </message>
    <message>
        <source>Frame rail</source>
        <translation>Rahmenträger</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; exists already: choose another name.</source>
        <translation>„{0}“ gibt es schon: Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Not computed</source>
        <extracomment>States of a result. Documents store these texts; views translate them.</extracomment>
        <translation>Nicht berechnet</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Failed</source>
        <extracomment>State of a run -&gt; text for users.</extracomment>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Clear</source>
        <extracomment>Verdict of the core -&gt; text for users.</extracomment>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Below required</source>
        <translation>Unter Sollabstand</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Clash</source>
        <translation>Kollision</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>The rules ignore every neighbour, so there is nothing to check: change at least one rule.</source>
        <translation>Nach den Regeln werden alle Nachbarn ignoriert, daher gibt es nichts zu prüfen: Ändern Sie mindestens eine Regel.</translation>
    </message>
    <message>
        <source>These parts also moved when this motion was read, but stand still in this check: {0}. If they move at the same time, use Check mechanism.</source>
        <translation>Diese Teile bewegten sich beim Lesen dieser Bewegung ebenfalls, stehen in dieser Prüfung aber still: {0}. Wenn sie sich gleichzeitig bewegen, verwenden Sie „Mechanismus prüfen“.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is not an envelope: choose an envelope.</source>
        <translation>„{0}“ ist keine Hülle: Wählen Sie eine Hülle.</translation>
    </message>
    <message>
        <source>Each part of &quot;{0}&quot; has its own motion: use Check mechanism, or check each part with its motion.</source>
        <translation>Jedes Teil von „{0}“ hat seine eigene Bewegung: Verwenden Sie „Mechanismus prüfen“, oder prüfen Sie jedes Teil mit seiner Bewegung.</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoriert</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>smallest distance {0} at t = {1} s ({2})</source>
        <translation>kleinster Abstand {0} bei t = {1} s ({2})</translation>
    </message>
    <message>
        <source>smallest distance {0} (guaranteed: {1}) at t = {2} s ({3})</source>
        <translation>kleinster Abstand {0} (garantiert mindestens {1}) bei t = {2} s ({3})</translation>
    </message>
    <message>
        <source>contact, {0} deep</source>
        <translation>Kontakt, {0} tief</translation>
    </message>
    <message>
        <source>{0} clash</source>
        <translation>{0} kollidieren</translation>
    </message>
    <message>
        <source>{0} in contact</source>
        <translation>{0} in Kontakt</translation>
    </message>
    <message>
        <source>{0} below required</source>
        <translation>{0} unter Sollabstand</translation>
    </message>
    <message>
        <source>{0} in allowed contact</source>
        <translation>{0} in erlaubtem Kontakt</translation>
    </message>
    <message>
        <source>{0} ignored</source>
        <translation>{0} ignoriert</translation>
    </message>
    <message>
        <source>deepest clash {0} at t = {1} s ({2})</source>
        <translation>tiefste Kollision {0} bei t = {1} s ({2})</translation>
    </message>
    <message>
        <source>{0} table</source>
        <translation>{0} Tabelle</translation>
    </message>
    <message>
        <source>{0} checked</source>
        <translation>{0} geprüft</translation>
    </message>
    <message>
        <source>Compute envelope</source>
        <extracomment>window.
----------
9 to 10 units long.</extracomment>
        <translation>Hülle berechnen</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Hülle</translation>
    </message>
    <message>
        <source>Cavities cannot be kept if parts have motions of their own: clear Keep cavities, or create one envelope for each motion.</source>
        <translation>Hohlräume können nicht behalten werden, wenn Teile eigene Bewegungen haben: Schalten Sie „Hohlräume behalten“ aus, oder erzeugen Sie für jede Bewegung eine eigene Hülle.</translation>
    </message>
    <message>
        <source>The number of moving parts is {0}, but the number of own motions is {1}: give every part a motion of its own, or none.</source>
        <extracomment>Deflection of solids for the closer estimate, as a fraction of the part&apos;s size.</extracomment>
        <translation>Die Anzahl der bewegten Teile ist {0}, die der eigenen Bewegungen aber {1}: Geben Sie jedem Teil eine eigene Bewegung oder keinem.</translation>
    </message>
    <message>
        <source>{0}, improved</source>
        <translation>{0}, verbessert</translation>
    </message>
    <message>
        <source>There is no neighbour: choose parts as neighbours, or make other parts visible.</source>
        <extracomment>Lengths in mm, the time limit in s, the largest turn in degrees.</extracomment>
        <translation>Es gibt keinen Nachbarn: Wählen Sie Teile als Nachbarn, oder blenden Sie andere Teile ein.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has the interpolation None: choose another interpolation first.</source>
        <translation>„{0}“ hat die Interpolation „Keine“: Wählen Sie zuerst eine andere Interpolation.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; moves no visible part: show the parts, or choose another source.</source>
        <translation>„{0}“ bewegt kein sichtbares Teil: Blenden Sie die Teile ein, oder wählen Sie eine andere Quelle.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is left out, because it is visible only through a link: add its parts directly to the assembly, not as a link.</source>
        <translation>„{0}“ wird ausgelassen, weil es nur durch eine Verknüpfung sichtbar ist: Fügen Sie seine Teile direkt in die Baugruppe ein, nicht als Verknüpfung.</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <extracomment>If there are more pairs, the table lists only those that came close or have a rule.</extracomment>
        <translation>Mechanismus</translation>
    </message>
    <message>
        <source>There are {0} moving parts but {1} motions: give one motion for each part.</source>
        <translation>Es gibt {0} bewegte Teile, aber {1} Bewegungen: Geben Sie für jedes Teil eine Bewegung an.</translation>
    </message>
    <message>
        <source>The motions do not overlap in time: &quot;{0}&quot; ends at {1} s, and &quot;{2}&quot; begins at {3} s. Change their times so that they overlap.</source>
        <translation>Die Bewegungen überschneiden sich zeitlich nicht: „{0}“ endet bei {1} s, und „{2}“ beginnt bei {3} s. Ändern Sie ihre Zeiten so, dass sie sich überschneiden.</translation>
    </message>
    <message>
        <source>The document changed while its parts were read: start the run again.</source>
        <translation>Das Dokument hat sich geändert, während seine Teile gelesen wurden: Starten Sie den Lauf noch einmal.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has no motion: choose one in the table.</source>
        <translation>„{0}“ hat keine Bewegung: Wählen Sie eine in der Tabelle.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is in the list twice: remove one entry.</source>
        <translation>„{0}“ steht zweimal in der Liste: Entfernen Sie einen Eintrag.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; and &quot;{1}&quot;: one of them contains the other, so the inner part would move twice. Remove one of them from the list.</source>
        <translation>„{0}“ und „{1}“: Eines enthält das andere, daher würde das innere Teil zweimal bewegt. Entfernen Sie eines aus der Liste.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has the interpolation None, so its part does not move between its poses: choose another interpolation for parts that move at the same time.</source>
        <translation>„{0}“ hat die Interpolation „Keine“, daher bewegt sich das Teil zwischen seinen Lagen nicht: Wählen Sie für Teile, die sich gleichzeitig bewegen, eine andere Interpolation.</translation>
    </message>
    <message>
        <source>Only one part is given: add a second part, either a moving part or a neighbour.</source>
        <translation>Es ist nur ein Teil angegeben: Fügen Sie ein zweites hinzu, entweder ein bewegtes Teil oder einen Nachbarn.</translation>
    </message>
    <message>
        <source>{0}, none nearer than {1}</source>
        <translation>{0}, keines näher als {1}</translation>
    </message>
    <message>
        <source>{0} pairs checked</source>
        <extracomment>Words that replace words in the titles of the clearance table, because both parts may move.</extracomment>
        <translation>{0} Paare geprüft</translation>
    </message>
    <message>
        <source>{0} was deleted, and {1} needs it: choose a replacement in the property {2}, or undo the deletion.</source>
        <extracomment>Hidden property: [{property, label, name, left}]. left: what remained in the property.</extracomment>
        <translation>{0} wurde gelöscht, aber {1} braucht es: Wählen Sie in der Eigenschaft {2} einen Ersatz, oder machen Sie das Löschen rückgängig.</translation>
    </message>
    <message>
        <source>no poses yet</source>
        <extracomment>Interpolations for which the choice of the pivot matters.</extracomment>
        <translation>noch keine Lagen</translation>
    </message>
    <message>
        <source>Motion</source>
        <extracomment>The panel opened last, for tests and macros. FreeCAD does not give access to it.</extracomment>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Motion of {0}</source>
        <translation>Bewegung von {0}</translation>
    </message>
    <message>
        <source>The steps of &quot;{0}&quot; are large: near t = {1} s the part may be about {2} away from its true position. Record the motion again with smaller steps.</source>
        <extracomment>the square of the length.</extracomment>
        <translation>Die Schritte von „{0}“ sind groß: Bei t = {1} s kann das Teil um etwa {2} von seiner wahren Position abweichen. Zeichnen Sie die Bewegung mit kleineren Schritten neu auf.</translation>
    </message>
    <message>
        <source>No motion is chosen: choose one, or make one with New motion.</source>
        <translation>Es ist keine Bewegung gewählt: Wählen Sie eine, oder erzeugen Sie eine mit „Neue Bewegung“.</translation>
    </message>
    <message>
        <source>The reference part has no motion: choose its motion, or clear the reference part.</source>
        <translation>Das Bezugsteil hat keine Bewegung: Wählen Sie seine Bewegung, oder entfernen Sie das Bezugsteil.</translation>
    </message>
    <message>
        <source>A reference motion is chosen, but no reference part: choose the reference part too, or clear the reference motion.</source>
        <translation>Es ist eine Bezugsbewegung gewählt, aber kein Bezugsteil: Wählen Sie auch das Bezugsteil, oder entfernen Sie die Bezugsbewegung.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is not a motion: choose a motion.</source>
        <translation>„{0}“ ist keine Bewegung: Wählen Sie eine Bewegung.</translation>
    </message>
    <message>
        <source>There are two different rules for &quot;{0}&quot;: remove one of them.</source>
        <translation>Für „{0}“ gibt es zwei verschiedene Regeln: Entfernen Sie eine davon.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has the unknown rule &quot;{1}&quot;: use Required, Contact or Ignore.</source>
        <translation>„{0}“ hat die unbekannte Regel „{1}“: Verwenden Sie Required, Contact oder Ignore.</translation>
    </message>
    <message>
        <source>The distance in the rule of &quot;{0}&quot; is {1} mm: enter 0 or more.</source>
        <translation>Der Abstand in der Regel von „{0}“ ist {1} mm: Geben Sie 0 oder mehr ein.</translation>
    </message>
    <message>
        <source>The rules of &quot;{0}&quot; are incomplete: each rule needs a part, a kind and a length, but there are {1} parts, {2} kinds and {3} lengths. Enter the rules again.</source>
        <translation>Die Regeln von „{0}“ sind unvollständig: Jede Regel braucht ein Teil, eine Art und eine Länge, vorhanden sind aber {1} Teile, {2} Arten und {3} Längen. Geben Sie die Regeln neu ein.</translation>
    </message>
    <message>
        <source>There is nothing to compare: choose two or more parts, envelopes or solids.</source>
        <translation>Es gibt nichts zu vergleichen: Wählen Sie zwei oder mehr Teile, Hüllen oder Festkörper.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; contains &quot;{1}&quot;: remove one of them.</source>
        <translation>„{0}“ enthält „{1}“: Entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>The rules for &quot;{0}&quot; and for &quot;{1}&quot; contradict each other for the pair &quot;{2}&quot;, and neither takes precedence: add a rule for exactly this pair.</source>
        <translation>Die Regeln für „{0}“ und für „{1}“ widersprechen sich für das Paar „{2}“, und keine hat Vorrang: Fügen Sie eine Regel für genau dieses Paar hinzu.</translation>
    </message>
    <message>
        <source>The rules of &quot;{0}&quot; are incomplete: each rule needs two parts, a kind and a length, but there are {1} parts, {2} kinds and {3} lengths. Enter the rules again.</source>
        <translation>Die Regeln von „{0}“ sind unvollständig: Jede Regel braucht zwei Teile, eine Art und eine Länge, vorhanden sind aber {1} Teile, {2} Arten und {3} Längen. Geben Sie die Regeln neu ein.</translation>
    </message>
    <message>
        <source>Path of {0}</source>
        <translation>Bahn von {0}</translation>
    </message>
    <message>
        <source>Check sequence</source>
        <translation>Einbaufolge prüfen</translation>
    </message>
    <message>
        <source>{0} of {1} parts have a path</source>
        <extracomment>The entries of a stored report that are used, with their shapes (base.fits()).</extracomment>
        <translation>{0} von {1} Teilen haben eine Bahn</translation>
    </message>
    <message>
        <source>clearance at least {0}</source>
        <translation>Abstand mindestens {0}</translation>
    </message>
    <message>
        <source>it is proven that no path exists without turning the part</source>
        <translation>es ist bewiesen, dass es ohne Drehen des Teils keine Bahn gibt</translation>
    </message>
    <message>
        <source>{0} parts, in this order: {1}</source>
        <translation>{0} Teile, in dieser Reihenfolge: {1}</translation>
    </message>
    <message>
        <source>no path found; blocked by {1} after {0} of travel</source>
        <translation>keine Bahn gefunden; nach {0} blockiert durch {1}</translation>
    </message>
    <message>
        <source>It is proven that the parts cannot be installed one after the other in any order.</source>
        <translation>Es ist bewiesen, dass die Teile in keiner Reihenfolge nacheinander eingebaut werden können.</translation>
    </message>
    <message>
        <source>path of {0}, clearance {1}</source>
        <translation>Bahn von {0}, Abstand {1}</translation>
    </message>
    <message>
        <source>path of {0}, no obstacles</source>
        <translation>Bahn von {0}, keine Hindernisse</translation>
    </message>
    <message>
        <source>There are {0} parts but {1} motions: give one motion for each part.</source>
        <translation>Es gibt {0} Teile, aber {1} Bewegungen: Geben Sie für jedes Teil eine Bewegung an.</translation>
    </message>
    <message>
        <source>The list of parts is empty: select the parts, then press Add selected.</source>
        <extracomment>removed. MostMoves: as in the command-line program; 0: no limit.</extracomment>
        <translation>Die Liste der Teile ist leer: Wählen Sie die Teile aus, und klicken Sie auf „Auswahl hinzufügen“.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has the interpolation None: choose another interpolation, or choose &quot;find a path&quot; as the motion of this part.</source>
        <translation>„{0}“ hat die Interpolation „Keine“: Wählen Sie eine andere Interpolation, oder wählen Sie „Bahn finden“ als Bewegung dieses Teils.</translation>
    </message>
    <message>
        <source>The two compared objects or groups share no volume. The smallest distance between them is {0}.</source>
        <translation>Die beiden verglichenen Objekte oder Gruppen haben kein Volumen gemeinsam. Der kleinste Abstand zwischen ihnen ist {0}.</translation>
    </message>
    <message>
        <source>Shared volume</source>
        <translation>Gemeinsames Volumen</translation>
    </message>
    <message>
        <source>A shared volume needs two sides: choose two parts or envelopes.</source>
        <extracomment>mm; smaller distances count as contact.</extracomment>
        <translation>Ein gemeinsames Volumen braucht zwei Seiten: Wählen Sie zwei Teile oder Hüllen.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is on both sides: choose another object for one of them.</source>
        <translation>„{0}“ ist auf beiden Seiten gewählt: Wählen Sie für eine davon ein anderes Objekt.</translation>
    </message>
    <message>
        <source>The envelope has no mesh yet: compute it first.</source>
        <extracomment>limit); tessellated: write the triangles unchanged, as a STEP file.</extracomment>
        <translation>Die Hülle hat noch kein Netz: Berechnen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>At one edge, the gap between two faces of the solid is {0}. It should be at most {1}: the Tolerance or the deviation of the solid from the envelope, whichever is larger, but at least 0.001 mm. A smaller Tolerance gives more faces and smaller gaps.</source>
        <translation>An einer Kante beträgt der Spalt zwischen zwei Flächen des Festkörpers {0}. Er sollte höchstens {1} betragen. Dieser Grenzwert ist der größte von drei Werten: die Toleranz, die Abweichung des Festkörpers von der Hülle und 0,001 mm. Eine kleinere Toleranz ergibt mehr Flächen und kleinere Spalte.</translation>
    </message>
    <message>
        <source>The envelope is conservative, but a solid with a tolerance could cut into the swept volume: set the Tolerance of the solid to 0.</source>
        <translation>Die Hülle ist konservativ, aber ein Festkörper mit einer Toleranz könnte in das überstrichene Volumen hineinschneiden: Setzen Sie die Toleranz des Festkörpers auf 0.</translation>
    </message>
    <message>
        <source>{0} solid</source>
        <translation>{0} Festkörper</translation>
    </message>
    <message>
        <source>Checking whether large parts have changed ...</source>
        <extracomment>compare its inputs again. None: there is no window, and parts are read at once.</extracomment>
        <translation>Große Teile werden auf Änderungen geprüft ...</translation>
    </message>
    <message>
        <source>Left out: {0}</source>
        <extracomment>Largest number of names in one sentence.</extracomment>
        <translation>Ausgelassen: {0}</translation>
    </message>
    <message>
        <source>Left out: {0}. Envelopes and their solids are checked only if you choose them as neighbours.</source>
        <translation>Ausgelassen: {0}. Hüllen und ihre Festkörper werden nur geprüft, wenn Sie sie als Nachbarn wählen.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is both a neighbour and a moving part: remove it from one of the lists.</source>
        <translation>„{0}“ ist zugleich Nachbar und bewegtes Teil: Entfernen Sie es aus einer der Listen.</translation>
    </message>
    <message>
        <source>{0} of {1} runs are not done. Start the study again to continue.</source>
        <translation>{0} von {1} Läufen sind nicht fertig: Starten Sie die Studie erneut, um fortzufahren.</translation>
    </message>
    <message>
        <source>The results of the study cannot be found in their folder: run the study again.</source>
        <translation>Die Ergebnisse der Studie sind nicht in ihrem Ordner zu finden: Führen Sie die Studie erneut aus.</translation>
    </message>
    <message>
        <source>Run study</source>
        <translation>Studie ausführen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>The result of &quot;{0}&quot; is not up to date: run the study again first.</source>
        <extracomment>Position of the checksum in the header of a file in an archive, after the time.</extracomment>
        <translation>Das Ergebnis von „{0}“ ist nicht aktuell: Führen Sie die Studie zuerst erneut aus.</translation>
    </message>
    <message>
        <source>Each part of &quot;{0}&quot; has its own motion, but a run of a study has only one motion: leave &quot;{0}&quot; out, or give its parts one common motion.</source>
        <extracomment>Options of an envelope that have the same names in studies. Values 0 and False are left out.</extracomment>
        <translation>Jedes Teil von „{0}“ hat seine eigene Bewegung, aber ein Lauf einer Studie hat nur eine Bewegung: Lassen Sie „{0}“ weg, oder geben Sie seinen Teilen eine gemeinsame Bewegung.</translation>
    </message>
    <message>
        <source>Studies cannot use the setting Components of &quot;{0}&quot;: set it to Consistent.</source>
        <translation>Studien können die Einstellung „Flächenstücke“ von „{0}“ nicht verwenden: Setzen Sie sie auf „Stimmig“.</translation>
    </message>
    <message>
        <source>The study file no longer contains the run &quot;{0}&quot;: run the study again to update the list.</source>
        <translation>Die Studiendatei enthält den Lauf „{0}“ nicht mehr: Führen Sie die Studie erneut aus, um die Liste zu erneuern.</translation>
    </message>
    <message>
        <source>Run {0}</source>
        <extracomment>Options of a run -&gt; properties; lengths in mm.</extracomment>
        <translation>Lauf {0}</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be a run of a study: choose envelopes, or clearance checks with one motion.</source>
        <translation>„{0}“ kann kein Lauf einer Studie sein: Wählen Sie Hüllen und Abstandsprüfungen mit einer Bewegung.</translation>
    </message>
    <message>
        <source>The study has no runs: choose a study file, or envelopes and clearance checks.</source>
        <translation>Die Studie hat keine Läufe: Wählen Sie eine Studiendatei oder Hüllen und Abstandsprüfungen.</translation>
    </message>
    <message>
        <source>There is no folder for the results: save the document first, or choose a folder.</source>
        <translation>Es gibt keinen Ordner für die Ergebnisse: Speichern Sie zuerst das Dokument, oder wählen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>Not clear</source>
        <translation>Nicht frei</translation>
    </message>
    <message>
        <source>Not run</source>
        <translation>Nicht gerechnet</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Allowed contact</source>
        <extracomment>The entries of a stored report that are used, with their shapes (base.fits()).</extracomment>
        <translation>Erlaubter Kontakt</translation>
    </message>
    <message>
        <source>{0} failed</source>
        <translation>{0} fehlgeschlagen</translation>
    </message>
    <message>
        <source>{0} not clear</source>
        <translation>{0} nicht frei</translation>
    </message>
    <message>
        <source>{0} not run</source>
        <translation>{0} nicht gerechnet</translation>
    </message>
    <message>
        <source>{0} done</source>
        <translation>{0} fertig</translation>
    </message>
    <message>
        <source>{0} deep</source>
        <extracomment>Verdicts, the worst first.</extracomment>
        <translation>{0} tief</translation>
    </message>
    <message>
        <source>{0} runs</source>
        <translation>{0} Läufe</translation>
    </message>
    <message>
        <source>t = {0} s</source>
        <translation>t = {0} s</translation>
    </message>
    <message>
        <source>The report template &quot;{0}&quot; is empty: choose another template in the preferences.</source>
        <translation>Die Berichtsvorlage „{0}“ ist leer: Wählen Sie eine andere in den Einstellungen.</translation>
    </message>
    <message>
        <source>changed since it was saved</source>
        <translation>seit dem Speichern geändert</translation>
    </message>
    <message>
        <source>The check &quot;{0}&quot; is not up to date. If it uses an envelope, recompute the envelope first; then run the check again.</source>
        <translation>Die Prüfung „{0}“ ist nicht aktuell. Wenn sie eine Hülle verwendet, berechnen Sie diese zuerst neu; führen Sie dann die Prüfung erneut aus.</translation>
    </message>
    <message>
        <source>The environment variable SOURCE_DATE_EPOCH is &quot;{0}&quot;, but must be a whole number of seconds since 1970-01-01: correct or unset it.</source>
        <extracomment>Fields of an Outcome that are still needed after its envelope was joined to others.</extracomment>
        <translation>Die Umgebungsvariable SOURCE_DATE_EPOCH ist „{0}“, muss aber eine ganze Zahl von Sekunden seit dem 1.1.1970 sein: Berichtigen oder löschen Sie sie.</translation>
    </message>
    <message>
        <source>The report template &quot;{0}&quot; cannot be read ({1}): choose another template in the preferences.</source>
        <translation>Die Berichtsvorlage „{0}“ kann nicht gelesen werden ({1}): Wählen Sie eine andere in den Einstellungen.</translation>
    </message>
    <message>
        <source>{0} triangles</source>
        <translation>{0} Dreiecke</translation>
    </message>
    <message>
        <source>{0} poses</source>
        <translation>{0} Lagen</translation>
    </message>
    <message>
        <source>A PDF file can be written only while the FreeCAD window is open. In scripts, write the report as HTML.</source>
        <translation>Eine PDF-Datei kann nur bei geöffnetem FreeCAD-Fenster erzeugt werden. Geben Sie den Bericht in Skripten als HTML aus.</translation>
    </message>
    <message>
        <source>document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Clearance table</source>
        <translation>Abstandstabelle</translation>
    </message>
    <message>
        <source>The envelope was computed relative to a moving part, so its clash volume has no fixed position in the document: run the check without a reference part.</source>
        <translation>Die Hülle wurde relativ zu einem bewegten Teil berechnet, daher hat ihr Kollisionsvolumen keine feste Position im Dokument: Führen Sie die Prüfung ohne Bezugsteil aus.</translation>
    </message>
    <message>
        <source>The cell size must be above 0 mm: enter a larger value.</source>
        <translation>Die Zellgröße muss größer als 0 mm sein: Geben Sie einen größeren Wert ein.</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 mm: enter a larger value.</source>
        <translation>Die Genauigkeit muss größer als 0 mm sein: Geben Sie einen größeren Wert ein.</translation>
    </message>
    <message>
        <source>Motion from file</source>
        <translation>Bewegung aus Datei</translation>
    </message>
    <message>
        <source>Select the moving part in the tree or in the 3D view.</source>
        <translation>Wählen Sie das bewegte Teil im Baum oder in der 3D-Ansicht aus.</translation>
    </message>
    <message>
        <source>This is an error in the workbench ({0}: {1}). Please report it with the details from the report view. See &quot;Report a fault&quot; in docs/handbook/troubleshooting.md.</source>
        <extracomment>Largest relative difference between a typed length and the value of its field, due to rounding.</extracomment>
        <translation>Dies ist ein Programmfehler des Arbeitsbereichs ({0}: {1}). Bitte melden Sie ihn mit den Einzelheiten aus dem Ausgabefenster. Siehe „Report a fault“ in docs/handbook/troubleshooting.md.</translation>
    </message>
    <message>
        <source>{0}: &quot;{1}&quot; is not a valid value (it would be read as {2}). Correct it.</source>
        <translation>{0}: „{1}“ ist kein gültiger Wert (er würde als {2} gelesen). Berichtigen Sie ihn.</translation>
    </message>
    <message>
        <source>If an envelope has an offset or is conservative, the faces that made it cannot be recorded: set Offset to 0 and switch Conservative off.</source>
        <translation>Für eine Hülle mit Versatz oder eine konservative Hülle kann nicht aufgezeichnet werden, welche Flächen sie erzeugt haben: Setzen Sie „Versatz“ auf 0, und schalten Sie „Konservativ“ aus.</translation>
    </message>
    <message>
        <source>Transform cannot be used while the motion editor is open: drag the chosen key, or enter numbers.</source>
        <translation>„Transformieren“ ist nicht möglich, solange der Bewegungseditor offen ist: Ziehen Sie die gewählte Stützstelle, oder geben Sie Zahlen ein.</translation>
    </message>
    <message>
        <source>There is no change of the keys to undo or redo.</source>
        <translation>Es gibt keine Änderung der Stützstellen, die rückgängig gemacht oder wiederholt werden kann.</translation>
    </message>
    <message>
        <source>There is no moving part: close the panel, select the part and open the panel again.</source>
        <translation>Es gibt kein bewegtes Teil: Schließen Sie das Panel, wählen Sie das Teil, und öffnen Sie das Panel neu.</translation>
    </message>
    <message>
        <source>A placement can be captured only as an absolute pose: set Pose type to Absolute.</source>
        <translation>Eine Platzierung kann nur als absolute Lage übernommen werden: Setzen Sie „Art der Lage“ auf „Absolut“.</translation>
    </message>
    <message>
        <source>Choose a key in the table first.</source>
        <translation>Wählen Sie zuerst eine Stützstelle in der Tabelle.</translation>
    </message>
    <message>
        <source>Motions of all parts</source>
        <translation>Bewegungen aller Teile</translation>
    </message>
    <message>
        <source>The motion &quot;{0}&quot; does not say which part it moves: add the part to the table of moving parts, then choose this motion in the row of the part.</source>
        <translation>Die Bewegung „{0}“ gibt nicht an, welches Teil sie bewegt: Fügen Sie das Teil zur Tabelle der bewegten Teile hinzu, und wählen Sie dann diese Bewegung in der Zeile des Teils.</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>Written: {0} ({1})
</source>
        <extracomment>Parts of the page that work only on a screen.</extracomment>
        <translation>Geschrieben: {0} ({1})
</translation>
    </message>
    <message>
        <source>The search moved the part at most {0} away from its goal before the part was blocked. The 3D view shows the part at that place.</source>
        <translation>Die Suche bewegte das Teil höchstens {0} von seinem Ziel weg, bevor es blockiert war. Die 3D-Ansicht zeigt das Teil an dieser Stelle.</translation>
    </message>
    <message>
        <source>Most frequent obstacle: {0}.</source>
        <translation>Häufigstes Hindernis: {0}.</translation>
    </message>
    <message>
        <source>A path exists with a clearance of {0}: reduce the required distance to find it.</source>
        <translation>Mit einem Abstand von {0} gibt es eine Bahn: Verringern Sie den Sollabstand, um sie zu finden.</translation>
    </message>
    <message>
        <source>{0} keys instead of {1}, length {2} instead of {3}, clearance {4} instead of {5}.</source>
        <translation>{0} Stützstellen statt {1}, Länge {2} statt {3}, Abstand {4} statt {5}.</translation>
    </message>
    <message>
        <source>It is proven that no path exists without turning the part.</source>
        <translation>Es ist bewiesen, dass es ohne Drehen des Teils keine Bahn gibt.</translation>
    </message>
    <message>
        <source>No section of the motion keeps the required distance: reduce the required distance, or use Find path.</source>
        <translation>Kein Abschnitt der Bewegung hält den Sollabstand ein: Verringern Sie den Sollabstand, oder verwenden Sie „Bahn finden“.</translation>
    </message>
    <message>
        <source>Number of sections of the path on which the distance stays below the required distance, because no other path was found: {0}.</source>
        <translation>Anzahl der Abschnitte der Bahn, auf denen der Abstand unter dem Sollabstand bleibt, weil keine andere Bahn gefunden wurde: {0}.</translation>
    </message>
    <message>
        <source>Number of sections of the path within the release distance of start and goal, which were left unchanged: {0}.</source>
        <translation>Anzahl der Abschnitte der Bahn, die innerhalb des Freigabeabstands von Start und Ziel liegen und unverändert bleiben: {0}.</translation>
    </message>
    <message>
        <source>Found a path: {0} keys, length {1}, total turn {2} degrees, clearance at least {3}.</source>
        <extracomment>Number of neighbours that are named. Further neighbours stop only few moves.</extracomment>
        <translation>Bahn gefunden: {0} Stützstellen, Länge {1}, Drehung insgesamt {2} Grad, Abstand mindestens {3}.</translation>
    </message>
    <message>
        <source>Within the release distance of {0}, the part is allowed to come closer than required to: {1}.</source>
        <translation>Innerhalb des Freigabeabstands von {0} um Start und Ziel darf das Teil den Sollabstand zu diesen Nachbarn unterschreiten: {1}.</translation>
    </message>
    <message>
        <source>No path was found within the time limit.</source>
        <translation>Innerhalb der Zeitgrenze wurde keine Bahn gefunden.</translation>
    </message>
    <message>
        <source>No path was found.</source>
        <translation>Es wurde keine Bahn gefunden.</translation>
    </message>
    <message>
        <source>A path exists only with a clearance near 0: reduce the required distance to find it.</source>
        <translation>Nur mit einem Abstand nahe 0 gibt es eine Bahn: Verringern Sie den Sollabstand, um sie zu finden.</translation>
    </message>
    <message>
        <source>Select a vertex, an edge or a face in the 3D view first. The vertex, or the centre of the edge or face, becomes the pivot.</source>
        <translation>Wählen Sie zuerst in der 3D-Ansicht einen Punkt, eine Kante oder eine Fläche: Der Punkt oder die Mitte der Kante oder Fläche wird zum Drehpunkt.</translation>
    </message>
    <message>
        <source>Select a face or an edge in the 3D view first, to set the direction.</source>
        <translation>Wählen Sie zuerst eine Fläche oder Kante in der 3D-Ansicht aus, um die Richtung festzulegen.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot;: enter {1} numbers, separated by spaces.</source>
        <translation>„{0}“: Geben Sie {1} Zahlen ein, durch Leerzeichen getrennt.</translation>
    </message>
    <message>
        <source>One of the parts in this row no longer exists: run the check again.</source>
        <translation>Eines der Teile in dieser Zeile existiert nicht mehr: Führen Sie die Prüfung erneut aus.</translation>
    </message>
    <message>
        <source>The distance in the rule of &quot;{0}&quot; is {1}: enter 0 or more.</source>
        <translation>Der Abstand in der Regel von „{0}“ ist {1}: Geben Sie 0 oder mehr ein.</translation>
    </message>
    <message>
        <source>There is no envelope in the document: make one with Create envelope.</source>
        <translation>Im Dokument gibt es keine Hülle: Erzeugen Sie eine mit „Hülle erzeugen“.</translation>
    </message>
    <message>
        <source>The document has {0} envelopes: select one of them.</source>
        <translation>Das Dokument enthält {0} Hüllen: Wählen Sie eine davon aus.</translation>
    </message>
    <message>
        <source>There is no motion in the document: make one with New motion.</source>
        <translation>Im Dokument gibt es keine Bewegung: Legen Sie eine mit „Neue Bewegung“ an.</translation>
    </message>
    <message>
        <source>The document has {0} motions: select one of them.</source>
        <translation>Das Dokument enthält {0} Bewegungen: Wählen Sie eine davon aus.</translation>
    </message>
    <message>
        <source>Select an envelope first.</source>
        <translation>Wählen Sie zuerst eine Hülle aus.</translation>
    </message>
    <message>
        <source>Select a motion first.</source>
        <translation>Wählen Sie zuerst eine Bewegung aus.</translation>
    </message>
    <message>
        <source>{0} could not be opened: install a web browser, or open the file yourself.</source>
        <translation>{0} konnte nicht geöffnet werden: Installieren Sie einen Webbrowser, oder öffnen Sie die Datei selbst.</translation>
    </message>
    <message>
        <source>Open run</source>
        <translation>Lauf öffnen</translation>
    </message>
    <message>
        <source>Look for contacts</source>
        <translation>Kontakte suchen</translation>
    </message>
    <message>
        <source>Read parts</source>
        <extracomment>Largest number of decimals. Smaller numbers are written with an exponent.</extracomment>
        <translation>Teile lesen</translation>
    </message>
    <message>
        <source>{0} triangles, {1}, {2}</source>
        <translation>{0} Dreiecke, {1}, {2}</translation>
    </message>
    <message>
        <source>Cancelled: the document was closed, or an object was deleted.</source>
        <extracomment>shown.</extracomment>
        <translation>Abgebrochen: Das Dokument wurde geschlossen oder ein Objekt gelöscht.</translation>
    </message>
    <message>
        <source>The temporary folder {0} is full: delete files there, or set the environment variable TMPDIR to another folder.</source>
        <translation>Der temporäre Ordner {0} ist voll: Schaffen Sie dort Platz, oder setzen Sie die Umgebungsvariable TMPDIR auf einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Studies need the Python package swept_volume, which is missing in {0}: install the workbench again, or build it with &quot;cmake --build build&quot;.</source>
        <extracomment>longest time (s) to wait for the end of its process and of the threads that read its output.</extracomment>
        <translation>Studien brauchen das Python-Paket swept_volume, das in {0} fehlt: Installieren Sie den Arbeitsbereich neu, oder kompilieren Sie ihn mit „cmake --build build“.</translation>
    </message>
    <message>
        <source>The program that runs the study ended with exit status {0} and wrote no result: run the study again. To see the output of the program, enter this command in a terminal: swept study &quot;{1}&quot;</source>
        <translation>Das Programm, das die Studie ausführt, hat sich mit dem Rückgabewert {0} beendet und kein Ergebnis geschrieben: Starten Sie die Studie erneut. Um die Ausgabe des Programms zu sehen, geben Sie in einem Terminal diesen Befehl ein: swept study &quot;{1}&quot;</translation>
    </message>
    <message>
        <source>Studies need the program {0}, but it was not found: install it.</source>
        <translation>Studien brauchen das Programm {0}, das nicht gefunden wurde: Installieren Sie es.</translation>
    </message>
    <message>
        <source>A Python module is missing ({0}): install it.</source>
        <translation>Ein Python-Modul fehlt ({0}): Installieren Sie es.</translation>
    </message>
    <message>
        <source>The study file &quot;{0}&quot; cannot be read: {1}</source>
        <translation>Die Studiendatei „{0}“ kann nicht gelesen werden: {1}</translation>
    </message>
    <message>
        <source>The file type &quot;{0}&quot; is not supported: use one of these: {1}.</source>
        <extracomment>for the template of the study, &quot;print&quot;, or a file).</extracomment>
        <translation>Der Dateityp „{0}“ wird nicht unterstützt: Verwenden Sie einen von diesen: {1}.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is the file of the document &quot;{1}&quot; and would be overwritten: choose another file.</source>
        <translation>„{0}“ ist die Datei des Dokuments „{1}“ und würde überschrieben: Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The folder &quot;{0}&quot; does not exist: create it, or choose another folder.</source>
        <translation>Der Ordner „{0}“ existiert nicht: Legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is a folder: enter the name of a file.</source>
        <translation>„{0}“ ist ein Ordner: Geben Sie den Namen einer Datei an.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is an input of &quot;{1}&quot; and would be overwritten: choose another file.</source>
        <translation>„{0}“ ist eine Eingabe von „{1}“ und würde überschrieben: Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Select one link array or Draft array.</source>
        <translation>Wählen Sie eine Link-Anordnung oder Draft-Anordnung aus.</translation>
    </message>
    <message>
        <source>Select an assembly simulation in the tree, then also the part whose motion you want.</source>
        <translation>Wählen Sie im Baum eine Baugruppensimulation aus, dann zusätzlich das Teil, dessen Bewegung Sie brauchen.</translation>
    </message>
    <message>
        <source>The simulation &quot;{0}&quot; stopped early, at {3} s of {4} s ({1} of {2} frames): its solver found no valid position. Check the joints and formulas, or set an earlier end time.</source>
        <translation>Die Simulation „{0}“ endete vorzeitig, bei {3} s von {4} s ({1} von {2} Bildern): Der Gleichungslöser der Simulation fand keine gültige Stellung. Prüfen Sie Gelenke und Formeln, oder geben Sie eine frühere Endzeit an.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be simulated by this version of FreeCAD: simulations need FreeCAD 1.1.</source>
        <translation>„{0}“ kann von dieser FreeCAD-Version nicht simuliert werden: Simulationen brauchen FreeCAD 1.1.</translation>
    </message>
    <message>
        <source>Select one CAM (Path) operation.</source>
        <extracomment>centre).</extracomment>
        <translation>Wählen Sie eine CAM-Operation (Path) aus.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has no moves (G0 to G3): choose another operation.</source>
        <translation>„{0}“ hat keine Fahrbewegungen (G0 bis G3): Wählen Sie eine andere Operation.</translation>
    </message>
    <message>
        <source>The motion file &quot;{0}&quot; does not exist: choose another file.</source>
        <translation>Die Bewegungsdatei „{0}“ existiert nicht: Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>A curve needs at least two poses: set Count to 2 or more, or to 0 (Accuracy then determines the number).</source>
        <extracomment>Below this fraction of a length, two points count as equal and two directions as parallel.</extracomment>
        <translation>Eine Kurve braucht mindestens zwei Lagen: Setzen Sie „Anzahl“ auf mindestens 2, oder auf 0 (die Genauigkeit bestimmt dann die Anzahl).</translation>
    </message>
    <message>
        <source>Select two wires: the curve to follow, then the curve that sets the orientation.</source>
        <translation>Wählen Sie zwei Linienzüge aus: die Leitkurve, dann die Kurve für die Ausrichtung.</translation>
    </message>
    <message>
        <source>Select one wire, edge or sketch to follow.</source>
        <translation>Wählen Sie einen Linienzug, eine Kante oder eine Skizze als Leitkurve aus.</translation>
    </message>
    <message>
        <source>The accuracy is {0}: enter a value greater than 0.</source>
        <translation>Die Genauigkeit ist {0}: Geben Sie einen Wert größer als 0 ein.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has {1} separate pieces: join them into one curve, or select one piece.</source>
        <translation>„{0}“ hat {1} getrennte Stücke: Verbinden Sie sie zu einer Kurve, oder wählen Sie ein Stück.</translation>
    </message>
    <message>
        <source>An accuracy of {0} needs more than {1} poses on this curve: enter a larger value, which is less accurate.</source>
        <translation>Eine Genauigkeit von {0} braucht auf dieser Kurve mehr als {1} Lagen: Geben Sie einen größeren, also ungenaueren Wert ein.</translation>
    </message>
    <message>
        <source>At the start of the curve &quot;{1}&quot;, its tangent passes through the second curve &quot;{0}&quot;. So the second curve does not define the z axis there: move it away from this tangent.</source>
        <translation>Am Anfang der Kurve „{1}“ verläuft deren Tangente durch die zweite Kurve „{0}“. Daher bestimmt die zweite Kurve dort die z-Achse nicht: Verschieben Sie sie von dieser Tangente weg.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has no value &quot;{1}&quot; that can be changed: choose one of {2}.</source>
        <translation>„{0}“ hat keinen änderbaren Wert „{1}“. Wählen Sie einen von diesen: {2}.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has no value that can be changed: choose another object.</source>
        <extracomment>Numbers of a placement (mm, degrees), such as an attachment offset.</extracomment>
        <translation>„{0}“ hat keinen Wert, der geändert werden kann: Wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>The document could not be recomputed with &quot;{0}&quot; = {1:g}: choose another start or end value.</source>
        <translation>Das Dokument konnte mit „{0}“ = {1:g} nicht neu berechnet werden: Wählen Sie einen anderen Anfangs- oder Endwert.</translation>
    </message>
    <message>
        <source>Select the object with the value to change, then the part whose motion you want.</source>
        <translation>Wählen Sie das Objekt mit dem Wert aus, der geändert wird, dann das Teil, dessen Bewegung Sie brauchen.</translation>
    </message>
    <message>
        <source>The value &quot;{0}&quot; of &quot;{1}&quot; cannot drive the motion, because the expression {2} computes it: choose a value that this expression uses.</source>
        <translation>Der Wert „{0}“ von „{1}“ kann die Bewegung nicht steuern, weil ihn der Ausdruck {2} berechnet: Wählen Sie einen Wert, den dieser Ausdruck verwendet.</translation>
    </message>
    <message>
        <source>The clipboard has no rows of numbers: copy cells from a spreadsheet first.</source>
        <translation>Die Zwischenablage enthält keine Zeilen mit Zahlen: Kopieren Sie zuerst Zellen aus einer Tabelle.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is too large, or is neither a number nor a quantity that can be converted to {1}: correct the entry.</source>
        <translation>„{0}“ ist zu groß, oder weder eine Zahl noch eine Größe, die in {1} umgerechnet werden kann: Berichtigen Sie die Eingabe.</translation>
    </message>
    <message>
        <source>Row {0} of the pasted text has {1} columns: use either the four columns t, x, y, z, or the seven columns t, x, y, z, yaw, pitch, roll.</source>
        <translation>Zeile {0} des eingefügten Texts hat {1} Spalten: Verwenden Sie entweder die vier Spalten t, x, y, z oder die sieben Spalten t, x, y, z, Gier, Nick, Roll.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; stands still in all {1} frames: choose a part that moves, or check the joints and formulas.</source>
        <extracomment>rotation matrix).</extracomment>
        <translation>„{0}“ steht in allen {1} Bildern still: Wählen Sie ein Teil, das sich bewegt, oder prüfen Sie Gelenke und Formeln.</translation>
    </message>
    <message>
        <source>The simulation &quot;{0}&quot; gave no frames: open it and check that it runs.</source>
        <translation>Die Simulation „{0}“ ergab keine Bilder: Öffnen Sie sie, und prüfen Sie, ob sie läuft.</translation>
    </message>
    <message>
        <source>Choose at least one object with a placement.</source>
        <translation>Wählen Sie mindestens ein Objekt mit einer Platzierung.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has no placement, so it cannot be a pose: choose another object.</source>
        <translation>„{0}“ hat keine Platzierung und kann daher nicht als Lage dienen: Wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>Pose {0}: the time is {1:g}, but must be a finite number. Correct it.</source>
        <translation>Lage {0}: Die Zeit ist {1:g}, muss aber eine endliche Zahl sein. Berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>Pose {0}: its time {1:g} s is earlier than the time {2:g} s of the pose before. Correct one of these times; times must not decrease.</source>
        <translation>Lage {0}: Die Zeit {1:g} s dieser Lage liegt vor der Zeit {2:g} s der vorigen Lage. Berichtigen Sie eine dieser Zeiten; Zeiten dürfen nicht abnehmen.</translation>
    </message>
    <message>
        <source>The pose type &quot;{0}&quot; is unknown: use one of these: {1}.</source>
        <translation>Die Art der Lage „{0}“ ist unbekannt: Verwenden Sie eine von diesen: {1}.</translation>
    </message>
    <message>
        <source>The motion has {0} times but {1} placements: give one time for each placement.</source>
        <translation>Die Bewegung hat {0} Zeiten, aber {1} Platzierungen: Geben Sie zu jeder Platzierung eine Zeit an.</translation>
    </message>
    <message>
        <source>Poses {0} and {1} have the same time ({2:g} s): give them different times, because the motion is a spline or has a reference part.</source>
        <translation>Die Lagen {0} und {1} haben dieselbe Zeit ({2:g} s). Bei einem Spline oder mit einem Bezugsteil braucht jede Lage ihre eigene Zeit: Ändern Sie eine der beiden.</translation>
    </message>
    <message>
        <source>Select one Robot trajectory.</source>
        <translation>Wählen Sie eine Roboterbahn aus.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has {1} waypoints, but a motion needs at least two: add waypoints.</source>
        <translation>„{0}“ hat {1} Wegpunkte, aber eine Bewegung braucht mindestens zwei: Fügen Sie Wegpunkte hinzu.</translation>
    </message>
    <message>
        <source>The settings of the motion&apos;s source are damaged: create the motion again, or edit its keys with Edit motion, which removes the link to the source and keeps the poses.</source>
        <translation>Die Einstellungen der Quelle dieser Bewegung sind beschädigt: Legen Sie die Bewegung neu an. Oder bearbeiten Sie ihre Stützstellen mit „Bewegung bearbeiten“; dabei wird die Verknüpfung mit der Quelle entfernt, und die Lagen bleiben erhalten.</translation>
    </message>
    <message>
        <source>This motion has no source that could be read again: its poses are stored only in the document. To change them, choose Edit motion.</source>
        <translation>Diese Bewegung hat keine Quelle, die neu gelesen werden könnte: Die Lagen sind nur im Dokument gespeichert. Um sie zu ändern, wählen Sie „Bewegung bearbeiten“.</translation>
    </message>
    <message>
        <source>The number of poses is {0}: enter a number from {1} to {2}.</source>
        <extracomment>Limit for sources where each pose takes a step of Python or a recompute of the document.</extracomment>
        <translation>Die Anzahl der Lagen ist {0}: Geben Sie eine Zahl von {1} bis {2} ein.</translation>
    </message>
    <message>
        <source>The spline from pose {0} to pose {1} cannot be computed, because the numbers in the computation become too large: check the times, placements and given velocities of these poses.</source>
        <extracomment>line on each side. Given: the velocity stored with the key; the rotation is as for Auto.</extracomment>
        <translation>Der Spline von Lage {0} bis Lage {1} ist nicht berechenbar, weil zu große Zahlenwerte entstehen: Prüfen Sie Zeiten, Platzierungen und vorgegebene Geschwindigkeiten dieser Lagen.</translation>
    </message>
    <message>
        <source>The document &quot;{0}&quot; has no open 3D view: open one with &quot;Create new view&quot; in the menu View.</source>
        <extracomment>Triangles of the part in motion, and at its keys, where it is drawn many times.</extracomment>
        <translation>„{0}“ hat keine offene 3D-Ansicht: Öffnen Sie im Menü „Ansicht“ eine neue Ansicht.</translation>
    </message>
    <message>
        <source>Made by the face itself at one of the poses, not by its motion between the poses</source>
        <extracomment>Number of results of one envelope whose records are kept, for Undo.</extracomment>
        <translation>Von der Fläche selbst in einer der Lagen erzeugt, nicht durch ihre Bewegung dazwischen</translation>
    </message>
    <message>
        <source>Swept by an edge that passed here</source>
        <translation>Überstrichen von einer Kante, die hier vorbeikam</translation>
    </message>
    <message>
        <source>Swept by a face that passed here</source>
        <translation>Überstrichen von einer Fläche, die hier vorbeikam</translation>
    </message>
    <message>
        <source>{0}, at {1:.3f} s</source>
        <translation>{0}, bei {1:.3f} s</translation>
    </message>
    <message>
        <source>Face{0} of {1}</source>
        <translation>Face{0} von {1}</translation>
    </message>
    <message>
        <source>triangle {0} of {1}</source>
        <extracomment>1); time: s; motion: name of the motion object.</extracomment>
        <translation>Dreieck {0} von {1}</translation>
    </message>
    <message>
        <source>the edge between {0} and {1}</source>
        <translation>die Kante zwischen {0} und {1}</translation>
    </message>
    <message>
        <source>Result</source>
        <extracomment>line.
----------
path&apos;s size.</extracomment>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>These distances are measured between the meshes. From the distance in the line above, the possible deviation of the meshes from the parts has already been subtracted</source>
        <translation>Diese Abstände sind zwischen den Netzen gemessen. Vom Abstand in der Zeile darüber ist schon abgezogen, wie weit die Netze von den Teilen abweichen können</translation>
    </message>
    <message>
        <source>Colour the &amp;parts by their verdicts</source>
        <translation>&amp;Teile nach ihren Urteilen färben</translation>
    </message>
    <message>
        <source>CSV...</source>
        <translation>CSV...</translation>
    </message>
    <message>
        <source>Spreadsheet</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Report...</source>
        <translation>Bericht...</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>{0} (stale: run the check again)</source>
        <translation>{0} (veraltet: erneut prüfen)</translation>
    </message>
    <message>
        <source>Pre&amp;vious place</source>
        <translation>Vori&amp;ge Stelle</translation>
    </message>
    <message>
        <source>Goes back to the previous place, where the clash is deeper or the distance is smaller than at the current place</source>
        <translation>Geht zurück zur vorigen Stelle. Dort ist die Kollision tiefer oder der Abstand kleiner als an der jetzigen Stelle</translation>
    </message>
    <message>
        <source>&amp;Next worst place</source>
        <translation>&amp;Nächstschlimmste Stelle</translation>
    </message>
    <message>
        <source>Goes to the next place. Clashes come first, beginning with the deepest, then all other places, beginning with the closest</source>
        <translation>Geht zur nächsten Stelle. Zuerst kommen die Kollisionen, beginnend mit der tiefsten, dann alle anderen Stellen, beginnend mit der engsten</translation>
    </message>
    <message>
        <source>Rule: {0}</source>
        <translation>Regel: {0}</translation>
    </message>
    <message>
        <source>No parts are in contact at the first pose.</source>
        <translation>In der ersten Lage sind keine Teile in Kontakt.</translation>
    </message>
    <message>
        <source>Contact is now allowed for these parts. Check that this is intended: {0}</source>
        <translation>Für diese Teile ist Kontakt jetzt erlaubt. Prüfen Sie, ob das gewollt ist: {0}</translation>
    </message>
    <message>
        <source>{0}: {1} {2} at {3} s</source>
        <translation>{0}: {1} {2} bei {3} s</translation>
    </message>
    <message>
        <source>There is no graph yet: run the check first.</source>
        <extracomment>points at a line.</extracomment>
        <translation>Es gibt noch kein Diagramm: Führen Sie zuerst die Prüfung aus.</translation>
    </message>
    <message>
        <source>distance ({0}) over time (s)</source>
        <translation>Abstand ({0}) über der Zeit (s)</translation>
    </message>
    <message>
        <source>(parts and motion below)</source>
        <translation>(Teile und Bewegung unten)</translation>
    </message>
    <message>
        <source>Neighbours ({0}): {1}</source>
        <translation>Nachbarn ({0}): {1}</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Moving parts</source>
        <translation>Bewegte Teile</translation>
    </message>
    <message>
        <source>All visible</source>
        <translation>Alle sichtbaren</translation>
    </message>
    <message>
        <source>All other visible parts are neighbours</source>
        <translation>Alle anderen sichtbaren Teile sind Nachbarn</translation>
    </message>
    <message>
        <source>Ta&amp;ke selected as neighbours</source>
        <translation>Auswahl als &amp;Nachbarn</translation>
    </message>
    <message>
        <source>Required distance</source>
        <translation>Sollabstand</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <extracomment>Steps of the quality slider, in cells along the longest side.</extracomment>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Mesh deflection</source>
        <translation>Netzabweichung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Allows contact with the neighbours that the moving parts touch at the first pose</source>
        <translation>Erlaubt den Kontakt mit Nachbarn, die ein bewegtes Teil schon in der ersten Lage berührt</translation>
    </message>
    <message>
        <source>Allow initial con&amp;tacts</source>
        <translation>Anfangs&amp;kontakte erlauben</translation>
    </message>
    <message>
        <source>Neighbour</source>
        <translation>Nachbar</translation>
    </message>
    <message>
        <source>Creates an object from the volume that the envelope shares with the part of the chosen row</source>
        <translation>Erzeugt ein Objekt aus dem Volumen, das die Hülle mit dem Teil der gewählten Zeile gemeinsam hat</translation>
    </message>
    <message>
        <source>Colour the envelope by distance</source>
        <translation>Hülle nach Abstand einfärben</translation>
    </message>
    <message>
        <source>clash: inside</source>
        <translation>Kollision: innen</translation>
    </message>
    <message>
        <source>contact: up to</source>
        <translation>Kontakt: bis</translation>
    </message>
    <message>
        <source>below required: up to</source>
        <translation>unter Sollabstand: bis</translation>
    </message>
    <message>
        <source>clear: beyond</source>
        <translation>frei: darüber</translation>
    </message>
    <message>
        <source>The envelope has changed since the check: run the check again.</source>
        <translation>Die Hülle hat sich seit der Prüfung geändert: Prüfen Sie erneut.</translation>
    </message>
    <message>
        <source>Keep volume to cut awa&amp;y</source>
        <translation>Abzutragendes Volumen behal&amp;ten</translation>
    </message>
    <message>
        <source>{0}, version {1}, for Python {2}</source>
        <translation>{0}, Version {1}, für Python {2}</translation>
    </message>
    <message>
        <source>What is fetched</source>
        <translation>Was heruntergeladen wird</translation>
    </message>
    <message>
        <source>asking pip...</source>
        <translation>pip wird gefragt ...</translation>
    </message>
    <message>
        <source>Package</source>
        <translation>Paket</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Into</source>
        <translation>Zielordner</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>Installieren</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>Aus einer Datei...</translation>
    </message>
    <message>
        <source>Installs a package file (.whl) that you have downloaded or built.</source>
        <translation>Installiert eine Paketdatei (.whl), die Sie heruntergeladen oder kompiliert haben.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Installed. You can use the workbench now.</source>
        <translation>Installiert. Sie können den Arbeitsbereich jetzt benutzen.</translation>
    </message>
    <message>
        <source>Installed. Start FreeCAD again to use it.</source>
        <translation>Installiert. Starten Sie FreeCAD neu, um ihn zu benutzen.</translation>
    </message>
    <message>
        <source>about {0} MB</source>
        <translation>etwa {0} MB</translation>
    </message>
    <message>
        <source>The core is installed: {0}</source>
        <translation>Der Rechenkern ist installiert: {0}</translation>
    </message>
    <message>
        <source>The core in {0} cannot be used, but FreeCAD would load it instead of an installed core. Build it again, or delete it.</source>
        <translation>Der Rechenkern in {0} kann nicht benutzt werden, aber FreeCAD würde ihn statt eines installierten laden. Kompilieren Sie ihn neu, oder löschen Sie ihn.</translation>
    </message>
    <message>
        <source>The workbench computes with a compiled Python package, its core. It is not installed for the Python {0} of this FreeCAD.</source>
        <translation>Der Arbeitsbereich rechnet mit einem kompilierten Python-Paket, dem Rechenkern. Für das Python {0} dieses FreeCAD ist er nicht installiert.</translation>
    </message>
    <message>
        <source>Swept envelope</source>
        <extracomment>The panel opened last, for tests and macros. FreeCAD does not give access to it.</extracomment>
        <translation>Bewegungshülle</translation>
    </message>
    <message>
        <source>; needs about {0} of memory and {1}</source>
        <translation>; braucht etwa {0} Speicher und {1}</translation>
    </message>
    <message>
        <source>{0} x {1} x {2} cells of {3}</source>
        <translation>{0} x {1} x {2} Zellen zu {3}</translation>
    </message>
    <message>
        <source>Largest distance allowed between the computed surface and the true one. It sets the cell size and the tolerance</source>
        <translation>Größter erlaubter Abstand zwischen der berechneten und der wahren Fläche. Er bestimmt Zellgröße und Toleranz</translation>
    </message>
    <message>
        <source>Coarse and fast on the left, fine and slow on the right</source>
        <translation>Links grob und schnell, rechts fein und langsam</translation>
    </message>
    <message>
        <source>How far simplification may move the surface. 0: no simplification</source>
        <translation>Wie weit die Vereinfachung die Oberfläche verschieben darf. 0: keine Vereinfachung</translation>
    </message>
    <message>
        <source>Grows the envelope by this distance on all sides</source>
        <translation>Vergrößert die Hülle auf allen Seiten um diesen Abstand</translation>
    </message>
    <message>
        <source>Set cell size by</source>
        <translation>Zellgröße vorgeben durch</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Conservative</source>
        <translation>Konservativ</translation>
    </message>
    <message>
        <source>Grows the envelope until it provably contains the swept volume</source>
        <translation>Vergrößert die Hülle, bis sie das überstrichene Volumen nachweislich enthält</translation>
    </message>
    <message>
        <source>Keep cavities</source>
        <translation>Hohlräume behalten</translation>
    </message>
    <message>
        <source>Keeps enclosed cavities as inner shells; otherwise they are filled</source>
        <translation>Behält eingeschlossene Hohlräume als innere Schalen; sonst werden sie gefüllt</translation>
    </message>
    <message>
        <source>Show a coarse envelope</source>
        <translation>Grobe Hülle zeigen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>For recordings with very many poses. Poses are skipped as long as no point of the part has moved farther than this length since the last pose used. 0: every pose is used</source>
        <translation>Für Aufzeichnungen mit sehr vielen Lagen. Lagen werden übersprungen, solange sich seit der letzten verwendeten Lage kein Punkt des Teils weiter als diese Länge bewegt hat. 0: Jede Lage wird verwendet</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Flächenstücke</translation>
    </message>
    <message>
        <source>Backend</source>
        <translation>Rechenwerk</translation>
    </message>
    <message>
        <source>Position filter</source>
        <translation>Lagenfilter</translation>
    </message>
    <message>
        <source>Records for each triangle which face or edge of which part made it, and when. The command &quot;What made this?&quot; shows the record. If it is stored in the document, the file becomes larger</source>
        <translation>Zeichnet für jedes Dreieck auf, welche Fläche oder Kante welches Teils es erzeugt hat, und wann. Der Befehl „Was hat das erzeugt?“ zeigt die Aufzeichnung. Wird sie im Dokument gespeichert, wird die Datei größer</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Erzeugt von</translation>
    </message>
    <message>
        <source>Reading the parts ...</source>
        <extracomment>Names of the buttons that start the run.</extracomment>
        <translation>Die Teile werden gelesen ...</translation>
    </message>
    <message>
        <source>Most poses are nearly equal: a position filter of {0} skips them and makes the run much faster.</source>
        <translation>Die meisten Lagen sind fast gleich: Ein Lagenfilter von {0} überspringt sie und macht den Lauf viel schneller.</translation>
    </message>
    <message>
        <source>The motion has only one pose, so the parts do not move: add another pose.</source>
        <translation>Die Bewegung hat nur eine Lage, die Teile bewegen sich also nicht: Fügen Sie eine weitere hinzu.</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Tabelle exportieren</translation>
    </message>
    <message>
        <source>Study file</source>
        <translation>Studiendatei</translation>
    </message>
    <message>
        <source>Folder for results</source>
        <translation>Ordner für Ergebnisse</translation>
    </message>
    <message>
        <source>{0} poses, {1} to {2} s, travel {3} x {4} x {5}</source>
        <translation>{0} Lagen, {1} bis {2} s, Verfahrweg {3} x {4} x {5}</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Pose type</source>
        <translation>Art der Lage</translation>
    </message>
    <message>
        <source>&amp;Find path</source>
        <translation>Bahn &amp;finden</translation>
    </message>
    <message>
        <source>Start and goal</source>
        <translation>Start und Ziel</translation>
    </message>
    <message>
        <source>&amp;Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Takes the part that is selected in the tree or in the 3D view</source>
        <translation>Übernimmt das Teil, das im Baum oder in der 3D-Ansicht ausgewählt ist</translation>
    </message>
    <message>
        <source>Part</source>
        <extracomment>boxes that are visible at first.</extracomment>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>The part never turns</source>
        <translation>Das Teil dreht sich nie</translation>
    </message>
    <message>
        <source>Largest angle by which the part may turn away from its orientation at the goal. 180: no limit</source>
        <translation>Größter Winkel, um den sich das Teil von seiner Ausrichtung am Ziel wegdrehen darf. 180: keine Grenze</translation>
    </message>
    <message>
        <source>Largest turn</source>
        <translation>Größte Drehung</translation>
    </message>
    <message>
        <source>Running &quot;{0}&quot; ...</source>
        <extracomment>Time (ms) until the dialog appears.</extracomment>
        <translation>„{0}“ läuft ...</translation>
    </message>
    <message>
        <source>&amp;Improve path</source>
        <translation>Bahn ver&amp;bessern</translation>
    </message>
    <message>
        <source>Key {0}, {1} s</source>
        <translation>Stützstelle {0}, {1} s</translation>
    </message>
    <message>
        <source>Tick a key to keep its placement and its time</source>
        <translation>Haken Sie eine Stützstelle an, um ihre Platzierung und Zeit zu behalten</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Increases the clearance, even if the path becomes longer. Otherwise the path becomes as short as the required distance allows</source>
        <translation>Vergrößert den Abstand, auch wenn die Bahn länger wird. Sonst wird die Bahn so kurz, wie der Sollabstand es erlaubt</translation>
    </message>
    <message>
        <source>Maximise clearance</source>
        <translation>Abstand maximieren</translation>
    </message>
    <message>
        <source>The last change of the keys</source>
        <extracomment>In Qt 6, QShortcut is in QtGui.</extracomment>
        <translation>Die letzte Änderung der Stützstellen</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gier</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nick</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>Key placements</source>
        <translation>Stützstellen</translation>
    </message>
    <message>
        <source>&amp;Capture</source>
        <extracomment>First characters of a number.</extracomment>
        <translation>Aufn&amp;ehmen</translation>
    </message>
    <message>
        <source>Adds the current placement of the part as a key (Ctrl+Return)</source>
        <translation>Fügt die aktuelle Platzierung des Teils als Stützstelle an (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Replaces the placement of this key with the current placement of the part</source>
        <translation>Ersetzt die Platzierung dieser Stützstelle durch die aktuelle des Teils</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>E&amp;infügen</translation>
    </message>
    <message>
        <source>Adds a key halfway to the next one (Insert)</source>
        <translation>Fügt eine Stützstelle auf halbem Weg zur nächsten ein (Einfg)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Verdoppeln</translation>
    </message>
    <message>
        <source>Adds the same placement again (Ctrl+D)</source>
        <translation>Fügt dieselbe Platzierung noch einmal an (Strg+D)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Removes the key (Delete)</source>
        <translation>Entfernt die Stützstelle (Entf)</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Reverses the order of the keys. The time between neighbouring keys stays the same</source>
        <translation>Kehrt die Reihenfolge der Stützstellen um. Die Zeit zwischen benachbarten Stützstellen bleibt gleich</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Moves the key one place earlier (Ctrl+Up)</source>
        <translation>Rückt die Stützstelle um einen Platz nach vorn (Strg+Auf)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Moves the key one place later (Ctrl+Down)</source>
        <translation>Rückt die Stützstelle um einen Platz nach hinten (Strg+Ab)</translation>
    </message>
    <message>
        <source>Eve&amp;n times</source>
        <translation>&amp;Gleiche Zeiten</translation>
    </message>
    <message>
        <source>Sets the times one second apart</source>
        <translation>Setzt die Zeiten im Abstand von einer Sekunde</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} bis {1}</translation>
    </message>
    <message>
        <source>Show the clearance while dragging</source>
        <extracomment>Whether the part clashes at its present placement.</extracomment>
        <translation>Abstand beim Ziehen zeigen</translation>
    </message>
    <message>
        <source>Stops the dragged key where the part would touch a neighbour. All other visible parts are neighbours</source>
        <translation>Hält die gezogene Stützstelle dort an, wo das Teil einen Nachbarn berühren würde. Als Nachbarn gelten alle anderen sichtbaren Teile</translation>
    </message>
    <message>
        <source>Clash with {1}</source>
        <translation>Kollision mit {1}</translation>
    </message>
    <message>
        <source>Stop at contact</source>
        <translation>Bei Kontakt anhalten</translation>
    </message>
    <message>
        <source>Contact with {1} ({0})</source>
        <translation>Kontakt mit {1} ({0})</translation>
    </message>
    <message>
        <source>The envelope is stale: the information shown belongs to its earlier parts and motion. Recompute the envelope to update the information.</source>
        <extracomment>The panel opened last, for tests and macros.</extracomment>
        <translation>Die Hülle ist veraltet: Die gezeigten Angaben gehören zu ihren früheren Teilen und ihrer früheren Bewegung. Berechnen Sie die Hülle neu, um die Angaben zu aktualisieren.</translation>
    </message>
    <message>
        <source>Compute and record</source>
        <translation>Berechnen und aufzeichnen</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Clicked place</source>
        <translation>Angeklickte Stelle</translation>
    </message>
    <message>
        <source>Select on the part</source>
        <translation>Am Teil auswählen</translation>
    </message>
    <message>
        <source>Click a place of the envelope in the 3D view.</source>
        <translation>Klicken Sie in der 3D-Ansicht auf eine Stelle der Hülle.</translation>
    </message>
    <message>
        <source>This envelope has no record of what made it. Either nothing was recorded, or the record was lost when the document was closed: press Compute and record.</source>
        <translation>Für diese Hülle ist nicht aufgezeichnet, woraus sie entstanden ist. Entweder wurde nichts aufgezeichnet, oder die Aufzeichnung ging beim Schließen des Dokuments verloren: Klicken Sie auf „Berechnen und aufzeichnen“.</translation>
    </message>
    <message>
        <source>It is not known what made this place: click a point beside it.</source>
        <translation>Was diese Stelle erzeugt hat, ist nicht bekannt: Klicken Sie auf einen Punkt daneben.</translation>
    </message>
    <message>
        <source>{0} neighbours that stand still: {1}</source>
        <translation>{0} stillstehende Nachbarn: {1}</translation>
    </message>
    <message>
        <source>All other visible parts are neighbours that stand still</source>
        <translation>Alle anderen sichtbaren Teile sind stillstehende Nachbarn</translation>
    </message>
    <message>
        <source>Allows contact between parts that touch at the start, for example at their joints</source>
        <translation>Erlaubt Kontakt zwischen Teilen, die sich am Anfang berühren, etwa an ihren Gelenken</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>none: select the part, then press Pick</source>
        <translation>keines: Wählen Sie das Teil aus, und klicken Sie auf „Wählen“</translation>
    </message>
    <message>
        <source>Increment when you drag an arrow (mm) or an arc (degrees) in the 3D view. 0: no increments</source>
        <translation>Schrittweite beim Ziehen eines Pfeils (mm) oder eines Bogens (Grad) in der 3D-Ansicht. 0: stufenlos</translation>
    </message>
    <message>
        <source>A motion needs at least two keys (poses): move the part, then press Capture.</source>
        <translation>Eine Bewegung braucht mindestens zwei Stützstellen (Lagen): Bewegen Sie das Teil, und klicken Sie auf „Aufnehmen“.</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>In der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Drag the chosen key</source>
        <translation>Gewählte Stützstelle ziehen</translation>
    </message>
    <message>
        <source>R&amp;ound</source>
        <translation>&amp;Runden</translation>
    </message>
    <message>
        <source>Rounds the placement of the chosen key to multiples of these increments</source>
        <translation>Rundet die Platzierung der gewählten Stützstelle auf Vielfache der Schrittweiten</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>&amp;Add selected</source>
        <translation>Auswahl hin&amp;zufügen</translation>
    </message>
    <message>
        <source>Adds the parts selected in the tree, and the parts of selected motions</source>
        <translation>Fügt die im Baum gewählten Teile hinzu und die Teile gewählter Bewegungen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>En&amp;tfernen</translation>
    </message>
    <message>
        <source>Add a&amp;ll its parts</source>
        <translation>A&amp;lle ihre Teile hinzufügen</translation>
    </message>
    <message>
        <source>Runs the chosen simulation or driving value once, and adds every part that moves. Existing motions of these parts are recorded again, missing ones are created</source>
        <translation>Führt die gewählte Simulation aus, oder ändert den gewählten steuernden Wert, und fügt jedes Teil hinzu, das sich bewegt. Vorhandene Bewegungen dieser Teile werden neu aufgezeichnet, fehlende erzeugt</translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation>(wählen)</translation>
    </message>
    <message>
        <source>Adds the solids and meshes selected in the tree</source>
        <translation>Fügt die im Baum ausgewählten Festkörper und Netze hinzu</translation>
    </message>
    <message>
        <source>All &amp;visible</source>
        <translation>Alle si&amp;chtbaren</translation>
    </message>
    <message>
        <source>Adds all other parts that are visible now</source>
        <translation>Fügt alle anderen Teile hinzu, die jetzt sichtbar sind</translation>
    </message>
    <message>
        <source>Reserved spaces</source>
        <translation>Reservierte Räume</translation>
    </message>
    <message>
        <source>{0} chosen: {1}</source>
        <translation>{0} gewählt: {1}</translation>
    </message>
    <message>
        <source>Pairs checked: {0}, none shares volume, smallest distance: {1}</source>
        <translation>Geprüfte Paare: {0}, keines mit gemeinsamem Volumen, kleinster Abstand: {1}</translation>
    </message>
    <message>
        <source>Ta&amp;ke selected</source>
        <translation>Aus&amp;wahl übernehmen</translation>
    </message>
    <message>
        <source>Adds the shared volume of the two objects to the document. If one of them changes later, the icon of the shared volume gets a clock: it is out of date</source>
        <translation>Fügt dem Dokument das gemeinsame Volumen der beiden Objekte hinzu. Ändert sich später eines davon, erhält das Symbol dieses Volumens eine Uhr: Es ist veraltet</translation>
    </message>
    <message>
        <source>Pairs checked: {0}, shared volume: {1}</source>
        <translation>Geprüfte Paare: {0}, gemeinsames Volumen: {1}</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Keep s&amp;hared volume</source>
        <translation>&amp;Gemeinsames Volumen behalten</translation>
    </message>
    <message>
        <source>Take selected</source>
        <translation>Auswahl übernehmen</translation>
    </message>
    <message>
        <source>Relative to a moving part</source>
        <translation>Relativ zu einem bewegten Teil</translation>
    </message>
    <message>
        <source>Computes the space that the moving parts occupy as seen from this part</source>
        <translation>Berechnet den Raum, den die bewegten Teile relativ zu diesem Teil einnehmen</translation>
    </message>
    <message>
        <source>Takes the part that is selected in the tree</source>
        <translation>Übernimmt das im Baum gewählte Teil</translation>
    </message>
    <message>
        <source>as below</source>
        <translation>wie unten</translation>
    </message>
    <message>
        <source>Own motion</source>
        <translation>Eigene Bewegung</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Bezugsteil</translation>
    </message>
    <message>
        <source>Reference motion</source>
        <translation>Bezugsbewegung</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Stützstellen</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Middle of the part</source>
        <extracomment>mm: a point this close to the middle of the part counts as the middle.</extracomment>
        <translation>Mitte des Teils</translation>
    </message>
    <message>
        <source>Origin of the poses</source>
        <translation>Ursprung der Lagen</translation>
    </message>
    <message>
        <source>Selected point</source>
        <translation>Gewählter Punkt</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>Set&amp;zen</translation>
    </message>
    <message>
        <source>Uses the selected vertex, or the centre of the selected edge or face, as the pivot</source>
        <translation>Verwendet den gewählten Eckpunkt oder die Mitte der gewählten Kante oder Fläche als Drehpunkt</translation>
    </message>
    <message>
        <source>In the coordinates of the part: {0}, {1}, {2}</source>
        <translation>In den Koordinaten des Teils: {0}, {1}, {2}</translation>
    </message>
    <message>
        <source>Current placement</source>
        <extracomment>distance in mm), Along (out in a direction).</extracomment>
        <translation>Aktuelle Platzierung</translation>
    </message>
    <message>
        <source>Given placement</source>
        <translation>Gegebene Platzierung</translation>
    </message>
    <message>
        <source>Out by a distance</source>
        <translation>Herausgezogen um eine Strecke</translation>
    </message>
    <message>
        <source>Out in a direction</source>
        <translation>Herausgezogen in einer Richtung</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Aus Auswahl</translation>
    </message>
    <message>
        <source>Direction (x, y, z) in which the part leaves its installed position. The button Take enters the normal of the selected face, or the direction of the selected edge</source>
        <translation>Richtung (x, y, z), in der das Teil seine Einbaulage verlässt. Die Schaltfläche „Aus Auswahl“ trägt die Normale der gewählten Fläche oder die Richtung der gewählten Kante ein</translation>
    </message>
    <message>
        <source>x, y, z ({0}), yaw, pitch, roll (degrees) of the part in the document. The button Take enters the placement of the selected object, or of the part if nothing is selected</source>
        <translation>x, y, z ({0}), Gier, Nick, Roll (Grad) des Teils im Dokument. Die Schaltfläche „Aus Auswahl“ trägt die Platzierung des gewählten Objekts ein, oder die des Teils, wenn nichts gewählt ist</translation>
    </message>
    <message>
        <source>Cuts the view at the place where the distance is smallest, and hides everything in front of it. The cut follows the selected row and the playback</source>
        <translation>Blendet alles vor der engsten Stelle aus. Der Schnitt folgt der gewählten Zeile und der Wiedergabe</translation>
    </message>
    <message>
        <source>Creates an object from the volume that the two parts of the chosen row share at the time of that row</source>
        <translation>Erzeugt ein Objekt aus dem Volumen, das die beiden Teile der gewählten Zeile zu deren Zeit gemeinsam haben</translation>
    </message>
    <message>
        <source>clash</source>
        <translation>Kollision</translation>
    </message>
    <message>
        <source>S&amp;ection through the closest place</source>
        <translation>&amp;Schnitt durch die engste Stelle</translation>
    </message>
    <message>
        <source>Keep clas&amp;h volume</source>
        <translation>Kollisions&amp;volumen behalten</translation>
    </message>
    <message>
        <source>Play</source>
        <extracomment>Seconds of the motion for each second of playing.</extracomment>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Time of the motion. A green ghost shows the part at this time</source>
        <translation>Zeitpunkt innerhalb der Bewegung. Ein grüner Schatten zeigt das Teil zu diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>Goes to the previous key</source>
        <translation>Geht zur vorigen Stützstelle</translation>
    </message>
    <message>
        <source>Pl&amp;ay</source>
        <translation>Ab&amp;spielen</translation>
    </message>
    <message>
        <source>Plays the motion, or pauses it. Speed 1 is real time</source>
        <translation>Spielt die Bewegung ab oder hält sie an. Geschwindigkeit 1 ist Echtzeit</translation>
    </message>
    <message>
        <source>Goes to the next key</source>
        <translation>Geht zur nächsten Stützstelle</translation>
    </message>
    <message>
        <source>Speed: seconds of the motion in one second of playback</source>
        <translation>Geschwindigkeit: Sekunden der Bewegung in einer Sekunde der Wiedergabe</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Starts again from the beginning when the end is reached</source>
        <translation>Spielt die Bewegung nach dem Ende wieder von vorn ab</translation>
    </message>
    <message>
        <source>P&amp;ause</source>
        <translation>Pau&amp;se</translation>
    </message>
    <message>
        <source>Volume: {0}</source>
        <translation>Volumen: {0}</translation>
    </message>
    <message>
        <source>Box: {0}</source>
        <translation>Hüllquader: {0}</translation>
    </message>
    <message>
        <source>Triangles: {0}, shells: {1}</source>
        <translation>Dreiecke: {0}, Schalen: {1}</translation>
    </message>
    <message>
        <source>Distance from the true surface: at most {0}</source>
        <translation>Abstand von der wahren Fläche: höchstens {0}</translation>
    </message>
    <message>
        <source>Last run: {0}</source>
        <translation>Letzter Lauf: {0}</translation>
    </message>
    <message>
        <source>Contact allowed</source>
        <translation>Kontakt erlaubt</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>Ignoriert</translation>
    </message>
    <message>
        <source>Double-click a cell, or press F2, to choose another rule</source>
        <translation>Doppelklick auf eine Zelle oder F2, um eine andere Regel zu wählen</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Required distance for this row (empty: the value of Required distance below). If contact is allowed: how deep the parts may overlap (empty: no deeper than the accuracy plus the mesh deflections of both parts)</source>
        <translation>Sollabstand für diese Zeile (leer: der Wert von „Sollabstand“ unten). Bei erlaubtem Kontakt: wie tief sich die Teile überschneiden dürfen (leer: höchstens um die Genauigkeit plus die Netzabweichungen beider Teile)</translation>
    </message>
    <message>
        <source>Required distance for this row (empty: the value of Required distance below)</source>
        <translation>Sollabstand für diese Zeile (leer: der Wert von „Sollabstand“ unten)</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>If the part is closer to a neighbour than required at the start or the goal, this is also allowed nearby: until some point of the part has moved farther than this length from the start or the goal</source>
        <translation>Liegt das Teil am Start oder am Ziel näher an einem Nachbarn als der Sollabstand, ist das auch in der Nähe erlaubt: bis sich ein Punkt des Teils weiter als diese Länge vom Start oder Ziel entfernt hat</translation>
    </message>
    <message>
        <source>Release distance</source>
        <translation>Freigabeabstand</translation>
    </message>
    <message>
        <source>The search uses random numbers; another seed may find another path</source>
        <translation>Die Suche verwendet Zufallszahlen; eine andere Startzahl findet vielleicht eine andere Bahn</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>&amp;Find paths in this order</source>
        <translation>Bahnen in dieser Reihenfolge &amp;finden</translation>
    </message>
    <message>
        <source>searching ({0} of {1} found)</source>
        <translation>wird gesucht ({0} von {1} gefunden)</translation>
    </message>
    <message>
        <source>Find an &amp;order</source>
        <translation>&amp;Reihenfolge finden</translation>
    </message>
    <message>
        <source>Finds an order in which the parts can be installed: searches for an order in which they can be removed, and reverses it</source>
        <translation>Findet eine Reihenfolge für den Einbau: sucht, in welcher Reihenfolge die Teile ausgebaut werden können, und kehrt sie um</translation>
    </message>
    <message>
        <source>A part counts as removed when it is this far from its installed position</source>
        <translation>Ein Teil gilt als ausgebaut, wenn es so weit von seiner Einbaulage entfernt ist</translation>
    </message>
    <message>
        <source>The parts never turn</source>
        <translation>Die Teile drehen sich nie</translation>
    </message>
    <message>
        <source>Removal distance</source>
        <translation>Ausbauabstand</translation>
    </message>
    <message>
        <source>{0} (stale: check again)</source>
        <translation>{0} (veraltet: neu prüfen)</translation>
    </message>
    <message>
        <source>Moving parts, in order of installation</source>
        <translation>Bewegte Teile, in der Reihenfolge des Einbaus</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>A&amp;dd selected</source>
        <translation>Auswahl hin&amp;zufügen</translation>
    </message>
    <message>
        <source>Adds the parts selected in the tree or in the view</source>
        <translation>Fügt die im Baum oder in der Ansicht gewählten Teile hinzu</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>&amp;Auf</translation>
    </message>
    <message>
        <source>D&amp;own</source>
        <translation>A&amp;b</translation>
    </message>
    <message>
        <source>find a path</source>
        <translation>Bahn finden</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Festkörper</translation>
    </message>
    <message>
        <source>Merge coplanar</source>
        <translation>Koplanare vereinigen</translation>
    </message>
    <message>
        <source>Merges adjacent coplanar triangles into one flat face</source>
        <translation>Vereinigt benachbarte koplanare Dreiecke zu einer ebenen Fläche</translation>
    </message>
    <message>
        <source>Largest number of faces of the solid. If the tolerance is 0 and the exact solid would have more faces, the solid is simplified with the smallest tolerance that is enough</source>
        <translation>Größte Anzahl der Flächen des Festkörpers. Ist die Toleranz 0 und hätte der genaue Festkörper mehr Flächen, wird er mit der kleinsten Toleranz vereinfacht, die ausreicht</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>Tessellated (AP242)</source>
        <translation>Tesselliert (AP242)</translation>
    </message>
    <message>
        <source>Writes the triangles themselves instead of faces. This is exact and fast, and there is no limit on the number of triangles. Only programs that read tessellated STEP can open the file: FreeCAD 1.1 can, FreeCAD 0.20 cannot</source>
        <translation>Schreibt die Dreiecke selbst statt Flächen. Das ist genau und schnell, und die Anzahl der Dreiecke ist nicht begrenzt. Nur Programme, die tesselliertes STEP lesen, können die Datei öffnen: FreeCAD 1.1 kann es, FreeCAD 0.20 nicht</translation>
    </message>
    <message>
        <source>Max faces</source>
        <translation>Max. Flächen</translation>
    </message>
    <message>
        <source>Estimating the solid ...</source>
        <translation>Der Festkörper wird abgeschätzt ...</translation>
    </message>
    <message>
        <source>{0} triangles: {1} faces,
about {2}, {3}</source>
        <translation>{0} Dreiecke: {1} Flächen,
etwa {2}, {3}</translation>
    </message>
    <message>
        <source>{0} triangles: at most {1} faces,
up to about {2}, {3}</source>
        <translation>{0} Dreiecke: höchstens {1} Flächen,
bis etwa {2}, {3}</translation>
    </message>
    <message>
        <source>Max file size</source>
        <translation>Max. Dateigröße</translation>
    </message>
    <message>
        <source>A tolerance of {0} is needed to meet the limits</source>
        <translation>Um die Grenzen einzuhalten, ist eine Toleranz von {0} nötig</translation>
    </message>
    <message>
        <source>Motion from object</source>
        <translation>Bewegung aus Objekt</translation>
    </message>
    <message>
        <source>Motion from driving value</source>
        <translation>Bewegung aus steuerndem Wert</translation>
    </message>
    <message>
        <source>No part is selected: every part that moves gets a motion.</source>
        <translation>Kein Teil ist ausgewählt: Jedes Teil, das sich bewegt, erhält eine Bewegung.</translation>
    </message>
    <message>
        <source>How far the straight line between two poses may deviate from the curve. Each corner of the curve gets a pose</source>
        <translation>Wie weit die Gerade zwischen zwei Lagen von der Kurve abweichen darf. Jede Ecke der Kurve erhält eine Lage</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>Second curve</source>
        <translation>Zweite Kurve</translation>
    </message>
    <message>
        <source>Fixed: the part never turns. Tangent: the x axis of the part follows the tangent. Second curve: as Tangent, and the z axis points to the second curve; select two curves, first the one that the part follows</source>
        <translation>Fest: Das Teil dreht sich nie. Tangente: Die x-Achse des Teils folgt der Tangente. Zweite Kurve: wie Tangente, und die z-Achse zeigt zur zweiten Kurve; wählen Sie zwei Kurven aus, die Leitkurve zuerst</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Tool head</source>
        <translation>Werkzeugkopf</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Rotary axes</source>
        <translation>Drehachsen</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Press OK again to use the motion as it is.</source>
        <translation>Klicken Sie noch einmal auf „OK“, um die Bewegung zu übernehmen, wie sie ist.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>The poses of &quot;{0}&quot; are linked to {1}. To edit a key, you must remove the link. The motion then keeps its current poses. Remove the link?</source>
        <translation>Die Lagen von „{0}“ sind mit {1} verknüpft. Um eine Stützstelle zu bearbeiten, müssen Sie die Verknüpfung entfernen. Die Bewegung behält dann ihre aktuellen Lagen. Verknüpfung entfernen?</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>default folder</source>
        <translation>Standardordner</translation>
    </message>
    <message>
        <source>one for each processor core</source>
        <translation>einer je Prozessorkern</translation>
    </message>
    <message>
        <source>Runs at once</source>
        <translation>Läufe gleichzeitig</translation>
    </message>
    <message>
        <source>Opens the report page of all runs in the web browser</source>
        <translation>Öffnet die Berichtsseite aller Läufe im Webbrowser</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortfahren</translation>
    </message>
    <message>
        <source>of this document</source>
        <translation>dieses Dokuments</translation>
    </message>
    <message>
        <source>of a study file</source>
        <translation>einer Studiendatei</translation>
    </message>
    <message>
        <source>&amp;Open worst</source>
        <translation>&amp;Schlimmsten öffnen</translation>
    </message>
    <message>
        <source>&amp;Open run</source>
        <translation>&amp;Lauf öffnen</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>{0} (stale: run again)</source>
        <translation>{0} (veraltet: erneut rechnen)</translation>
    </message>
    <message>
        <source>Run</source>
        <extracomment>Number of rows that determine the width of a column.</extracomment>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Tangent at the key</source>
        <translation>Tangente an der Stützstelle</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Given velocity</source>
        <translation>Gegebene Geschwindigkeit</translation>
    </message>
    <message>
        <source>Automatic: from the keys before and after. Stop: the part comes to rest. Corner: arrives in the direction from the previous key, leaves in the direction to the next key. Given velocity: as entered below</source>
        <translation>Automatisch: aus den Stützstellen davor und danach. Anhalten: Das Teil kommt zur Ruhe. Ecke: Das Teil kommt in Richtung der Geraden von der vorigen Stützstelle an und verlässt die Stützstelle in Richtung der Geraden zur nächsten. Gegebene Geschwindigkeit: wie unten eingegeben</translation>
    </message>
    <message>
        <source>Velocity along {0} (mm/s)</source>
        <translation>Geschwindigkeit entlang {0} (mm/s)</translation>
    </message>
    <message>
        <source>None</source>
        <extracomment>Values of properties and names of the core&apos;s stages that panels show, marked for translation.</extracomment>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Screw</source>
        <translation>Schraubung</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolut</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativ</translation>
    </message>
    <message>
        <source>RelativeToFirst</source>
        <translation>Relativ zur ersten</translation>
    </message>
    <message>
        <source>Consistent</source>
        <translation>Stimmig</translation>
    </message>
    <message>
        <source>DualContouring</source>
        <translation>DualContouring</translation>
    </message>
    <message>
        <source>DualMarchingCubes</source>
        <translation>DualMarchingCubes</translation>
    </message>
    <message>
        <source>Equivalence</source>
        <translation>Äquivalenz</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Gierig</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>input</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>sampling</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>signs</source>
        <translation>Innen und außen</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>export</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>straight moves</source>
        <translation>gerade Bewegungen</translation>
    </message>
    <message>
        <source>moves without turns</source>
        <translation>Bewegungen ohne Drehung</translation>
    </message>
    <message>
        <source>moves with turns</source>
        <translation>Bewegungen mit Drehung</translation>
    </message>
    <message>
        <source>polish</source>
        <translation>glätten</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>{0}, {1} s</source>
        <translation>{0}, {1} s</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Nothing</source>
        <extracomment>What the colours of an envelope can show; the first entry: its own colour.</extracomment>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Swept Volume</source>
        <translation>Überstrichener Raum</translation>
    </message>
    <message>
        <source>The space that moving parts need: motions, swept envelopes, solids, STEP</source>
        <translation>Der Raum, den bewegte Teile brauchen: Bewegungen, Hüllen, Festkörper, STEP</translation>
    </message>
    <message>
        <source>A mesh has gaps (open edges), so it has no definite inside and outside: close the gaps.</source>
        <translation>Ein Netz hat Lücken (offene Kanten) und damit kein eindeutiges Innen und Außen: Schließen Sie die Lücken.</translation>
    </message>
    <message>
        <source>The part has gaps (open edges). Its envelope is closed all the same.</source>
        <translation>Das Teil hat Lücken (offene Kanten). Seine Hülle ist trotzdem geschlossen.</translation>
    </message>
    <message>
        <source>Some poses have the same time.</source>
        <translation>Einige Lagen haben denselben Zeitpunkt.</translation>
    </message>
    <message>
        <source>The solid deviates from the envelope by {0}, which is more than its Tolerance of {1}. A smaller Tolerance usually reduces the deviation.</source>
        <translation>Der Festkörper weicht um {0} von der Hülle ab. Das ist mehr als seine Toleranz von {1}. Eine kleinere Toleranz verringert die Abweichung meist.</translation>
    </message>
    <message>
        <source>To stay within Max faces, the solid was simplified: it deviates from the envelope by up to {0}. Allow more faces, or set a Tolerance.</source>
        <translation>Um innerhalb von „Max. Flächen“ zu bleiben, wurde der Festkörper vereinfacht: Er weicht um bis zu {0} von der Hülle ab. Lassen Sie mehr Flächen zu, oder geben Sie eine Toleranz an.</translation>
    </message>
    <message>
        <source>The part has gaps (open edges) that its motion does not close. There, the part does not count as solid, and the envelope is only a thin sheet along each wall of the part: close the gaps if the part is solid there.</source>
        <translation>Das Teil hat Lücken (offene Kanten), die seine Bewegung nicht schließt. Dort gilt das Teil nicht als massiv, und die Hülle ist nur eine dünne Schicht entlang jeder Wand des Teils: Schließen Sie die Lücken, wenn das Teil dort massiv ist.</translation>
    </message>
    <message>
        <source>How pieces of surface inside one cell are separated. For research only: keep Consistent, which alone guarantees that the envelope is closed</source>
        <translation>Verfahren, das die Flächenstücke in einer Zelle trennt. Nur für die Forschung: Lassen Sie „Stimmig“ stehen, denn nur damit ist die Hülle sicher geschlossen</translation>
    </message>
    <message>
        <source>The motion &quot;{0}&quot; does not set start and goal: this needs the pose type Absolute and at least two poses. Enter start and goal below.</source>
        <translation>Die Bewegung „{0}“ legt Start und Ziel nicht fest: Dazu muss „Art der Lage“ auf „Absolut“ stehen, und sie braucht mindestens zwei Lagen. Geben Sie Start und Ziel unten ein.</translation>
    </message>
    <message>
        <source>Pairs of parts that come closer than this length are listed. 0: a tenth of the median size of the parts, or more if a rule needs it</source>
        <translation>Aufgelistet werden Paare von Teilen, deren Abstand kleiner wird als diese Länge. 0: ein Zehntel der mittleren Größe (Median) der Teile, oder mehr, wenn eine Regel es erfordert</translation>
    </message>
    <message>
        <source>Distance that the objects must keep from each other. 0: they may lie close together, but must not touch</source>
        <translation>Abstand, den die Objekte voneinander halten müssen. 0: Sie dürfen dicht beieinanderliegen, sich aber nicht berühren</translation>
    </message>
    <message>
        <source>Findings: {0}</source>
        <translation>Befunde: {0}</translation>
    </message>
    <message>
        <source>Distance that the path keeps from every neighbour. The default is smaller than that of a clearance check, because a larger distance closes narrow passages</source>
        <translation>Abstand, den die Bahn von jedem Nachbarn hält. Der Vorgabewert ist kleiner als der einer Abstandsprüfung, weil ein größerer Abstand enge Durchgänge versperrt</translation>
    </message>
    <message>
        <source>The file gets a new solid, made from the mesh of &quot;{0}&quot;. The stored solid is not used.</source>
        <translation>Die Datei erhält einen neuen Festkörper, der aus dem Netz von „{0}“ entsteht. Der gespeicherte Festkörper wird nicht verwendet.</translation>
    </message>
    <message>
        <source>The cell is too large for the part: the part is smaller than one cell, or everywhere thinner than one cell. Choose a smaller value of Accuracy, a smaller cell or a higher resolution.</source>
        <translation>Die Zelle ist zu groß für das Teil: Das Teil ist kleiner als eine Zelle oder an jeder Stelle dünner als eine Zelle. Wählen Sie eine höhere Genauigkeit (kleinerer Wert), eine kleinere Zelle oder eine höhere Auflösung.</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is not up to date, so the file will contain the result of its last run. To export the current state, recompute &quot;{0}&quot; first.</source>
        <translation>„{0}“ ist nicht aktuell, daher wird die Datei das Ergebnis des letzten Laufs enthalten. Um den aktuellen Stand zu exportieren, berechnen Sie „{0}“ zuerst neu.</translation>
    </message>
    <message>
        <source>Cell size: {0}, deviation by simplification: {1}</source>
        <translation>Zellgröße: {0}, Abweichung durch Vereinfachung: {1}</translation>
    </message>
    <message>
        <source>The folder &quot;{0}&quot; is write-protected: choose another folder, or change its permissions.</source>
        <translation>Der Ordner „{0}“ ist schreibgeschützt: Wählen Sie einen anderen Ordner, oder ändern Sie die Rechte.</translation>
    </message>
    <message>
        <source>The file &quot;{0}&quot; is write-protected: choose another name, or change its permissions.</source>
        <translation>Die Datei „{0}“ ist schreibgeschützt: Wählen Sie einen anderen Namen, oder ändern Sie die Rechte.</translation>
    </message>
    <message>
        <source>Removes the selected parts from the list</source>
        <translation>Entfernt die ausgewählten Teile aus der Liste</translation>
    </message>
    <message>
        <source>Computing time: {0} on the {1}</source>
        <translation>Rechenzeit: {0} auf der {1}</translation>
    </message>
    <message>
        <source>What the G-code words A, B and C rotate: the tool head, or the table with the workpiece. They are angles in degrees about the fixed axes x, then y, then z. For a tool head, X, Y and Z are coordinates of the workpiece; for a table, they are coordinates of the machine</source>
        <translation>Was die G-Code-Wörter A, B und C drehen: den Werkzeugkopf, oder den Tisch mit dem Werkstück. Sie sind Winkel in Grad um die festen Achsen x, dann y, dann z. Bei einem Werkzeugkopf sind X, Y und Z Koordinaten des Werkstücks, bei einem Tisch Koordinaten der Maschine</translation>
    </message>
    <message>
        <source>Removes the selected part from the sequence</source>
        <translation>Entfernt das ausgewählte Teil aus der Einbaufolge</translation>
    </message>
    <message>
        <source>Moves the selected part one step earlier</source>
        <translation>Rückt das ausgewählte Teil um einen Schritt nach vorn</translation>
    </message>
    <message>
        <source>Moves the selected part one step later</source>
        <translation>Rückt das ausgewählte Teil um einen Schritt nach hinten</translation>
    </message>
    <message>
        <source>FreeCAD cannot read &quot;{0}&quot;: {1}</source>
        <translation>FreeCAD kann „{0}“ nicht lesen: {1}</translation>
    </message>
    <message>
        <source>{0} (the core is not published there yet)</source>
        <translation>{0} (der Rechenkern ist dort noch nicht veröffentlicht)</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume that the two objects share</source>
        <translation>Gemeinsames Volumen der beiden Objekte</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Between two keys, the pivot follows the straight line (Linear) or the curve (Spline), and the part turns about it. The x, y and z of a key are the coordinates of the pivot, or its displacement if the pose type is Relative.</source>
        <translation>Zwischen zwei Stützstellen bewegt sich der Drehpunkt auf der Geraden (Linear) oder der Kurve (Spline), und das Teil dreht sich um ihn. x, y und z einer Stützstelle sind die Koordinaten des Drehpunkts, oder seine Verschiebung, wenn die Art der Lage Relativ ist.</translation>
    </message>
    <message>
        <source>This motion was recorded from an assembly simulation, which has no settings here. To change the motion, change the simulation, then choose Reload motion.</source>
        <translation>Diese Bewegung wurde aus einer Baugruppensimulation aufgezeichnet, die hier keine Einstellungen hat. Um die Bewegung zu ändern, ändern Sie die Simulation und wählen dann Bewegung neu laden.</translation>
    </message>
    <message>
        <source>Recomputes the selected envelope from its current parts and motion. Without a selection, recomputes the first envelope that is not up to date, or the only envelope</source>
        <translation>Berechnet die gewählte Hülle aus ihren aktuellen Teilen und ihrer aktuellen Bewegung neu. Ohne Auswahl wird die erste Hülle neu berechnet, die nicht aktuell ist, oder die einzige Hülle</translation>
    </message>
    <message>
        <source>All envelopes are up to date. To compute one of them again anyway, select it.</source>
        <translation>Alle Hüllen sind aktuell. Um eine davon trotzdem neu zu berechnen, wählen Sie sie aus.</translation>
    </message>
    <message>
        <source>Largest deviation from the mesh to aim at. Not guaranteed: the property Deviation of the solid is the measured value. 0: exact, unless Max faces requires a tolerance</source>
        <translation>Wie weit der Festkörper höchstens vom Netz abweichen soll. Nicht garantiert: Die Eigenschaft Deviation des Festkörpers ist der gemessene Wert. 0: genau, sofern „Max. Flächen“ keine Toleranz erfordert</translation>
    </message>
    <message>
        <source>Cavities inside the envelope were filled, because the part has gaps: close them to keep the cavities.</source>
        <translation>Hohlräume innerhalb der Hülle wurden gefüllt, weil das Teil Lücken hat: Schließen Sie sie, um die Hohlräume zu behalten.</translation>
    </message>
    <message>
        <source>If no path has been found after this time, the search fails. If one has been found, the search stops improving it</source>
        <translation>Ist nach dieser Zeit keine Bahn gefunden, endet die Suche ohne Ergebnis. Sonst endet nur das Verbessern der Bahn</translation>
    </message>
    <message>
        <source>Number of cells along the longest side of the box around the swept volume</source>
        <translation>Anzahl der Zellen entlang der längsten Seite des Quaders um das überstrichene Volumen</translation>
    </message>
    <message>
        <source>Two parts overlap in their installed positions, by more than the release distance allows: move one of them, or increase the release distance. The details in parentheses name the parts.</source>
        <translation>Zwei Teile überschneiden sich in ihren Einbaulagen, und zwar tiefer, als der Freigabeabstand erlaubt: Verschieben Sie eines davon, oder vergrößern Sie den Freigabeabstand. Die Angaben in Klammern nennen die Teile.</translation>
    </message>
    <message>
        <source>At a pose on the way, the part is too close to a neighbour, or overlaps it: reduce the required distance, or move or remove this pose. The details in parentheses name the pose and the neighbour.</source>
        <translation>An einer Lage auf dem Weg ist das Teil zu nah an einem Nachbarn oder überschneidet sich mit ihm: Verringern Sie den Sollabstand, oder ändern oder entfernen Sie diese Lage. Die Angaben in Klammern nennen die Lage und den Nachbarn.</translation>
    </message>
    <message>
        <source>The triangles of the part, or of one of its shells (connected pieces of surface), faced inwards. They were reversed.</source>
        <translation>Die Normalen der Dreiecke zeigten nach innen (beim ganzen Teil oder bei einer seiner Schalen, also einem zusammenhängenden Stück der Oberfläche). Die Dreiecke wurden umgedreht.</translation>
    </message>
    <message>
        <source>Some shells (connected pieces of surface) of the part lie inside other shells. They count as material.</source>
        <translation>Manche Schalen (zusammenhängende Stücke der Oberfläche) des Teils liegen in anderen Schalen. Sie zählen als Material.</translation>
    </message>
    <message>
        <source>The time of key {0} must be less than {2} s, not {3} s.</source>
        <extracomment>Larger numbers are not valid in a key; the core accepts up to 1e9 mm.</extracomment>
        <translation>Die Zeit der Stützstelle {0} muss kleiner als {2} s sein, nicht {3} s.</translation>
    </message>
    <message>
        <source>The time of key {0} must be more than {1} s, not {3} s.</source>
        <translation>Die Zeit der Stützstelle {0} muss größer als {1} s sein, nicht {3} s.</translation>
    </message>
    <message>
        <source>The time of key {0} must be more than {1} s and less than {2} s, not {3} s.</source>
        <translation>Die Zeit der Stützstelle {0} muss größer als {1} s und kleiner als {2} s sein, nicht {3} s.</translation>
    </message>
</context>
<context>
    <name>SweptVolumePreferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>New envelopes</source>
        <translation>Neue Hüllen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Cells along the longest side of the box around the swept volume, for new envelopes</source>
        <translation>Zellen entlang der längsten Seite des Quaders um das überstrichene Volumen, für neue Hüllen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far simplification may move the surface of a new envelope. 0: no simplification</source>
        <translation>Wie weit die Vereinfachung die Oberfläche einer neuen Hülle verschieben darf. 0: keine Vereinfachung</translation>
    </message>
    <message>
        <source>Backend</source>
        <translation>Rechenwerk</translation>
    </message>
    <message>
        <source>Processor that computes new envelopes</source>
        <translation>Prozessor, der neue Hüllen berechnet</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>GPU</source>
        <translation>GPU</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Number of threads of a run. With one thread fewer than processor cores, FreeCAD stays responsive while a large envelope is computed</source>
        <translation>Anzahl der Threads eines Laufs. Ist sie um eins kleiner als die Anzahl der Prozessorkerne, bleibt FreeCAD bedienbar, während eine große Hülle berechnet wird</translation>
    </message>
    <message>
        <source>all processor cores</source>
        <translation>alle Prozessorkerne</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <source>A computation that would need more memory is refused before it starts</source>
        <translation>Eine Berechnung, die mehr Speicher als diesen Wert bräuchte, wird vor dem Start abgelehnt</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>three quarters of the free memory</source>
        <translation>drei Viertel des freien Speichers</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>HTML file with placeholders, for reports and studies; empty: the built-in template</source>
        <translation>HTML-Datei mit Platzhaltern für Berichte und Studien; leer: die eingebaute Vorlage</translation>
    </message>
    <message>
        <source>PDF template</source>
        <translation>PDF-Vorlage</translation>
    </message>
    <message>
        <source>The template for PDF, in the HTML subset of Qt&apos;s rich text; empty: the built-in template</source>
        <translation>Die Vorlage für PDF, als HTML. Erlaubt ist der Teil von HTML, den die Bibliothek Qt darstellen kann. Leer: die eingebaute Vorlage</translation>
    </message>
    <message>
        <source>Motion editor</source>
        <translation>Bewegungseditor</translation>
    </message>
    <message>
        <source>Preview resolution</source>
        <translation>Auflösung der Vorschau</translation>
    </message>
    <message>
        <source>Cells along the longest side of the coarse envelope in the motion editor</source>
        <translation>Zellen entlang der längsten Seite der groben Hülle im Bewegungseditor</translation>
    </message>
    <message>
        <source>Show a coarse envelope while a motion is edited</source>
        <translation>Beim Bearbeiten einer Bewegung eine grobe Hülle zeigen</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Swept Volume</source>
        <extracomment>Commands that appear only in the menu.</extracomment>
        <translation>Überstrichener Raum</translation>
    </message>
    <message>
        <source>&amp;Swept Volume</source>
        <translation>Überstri&amp;chener Raum</translation>
    </message>
</context>
</TS>
