# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of clearance checks, written beside the window: HTML by the core, PDF through Qt."""
import os
import re
import tempfile

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import core, page, quantities
from ..features import clearance_table
from ..runner import Task
from ..safe_file import written_beside
from ..texts import translate

try:
    from PySide import QtSvg
except ImportError:  # then the PDF has no graph
    QtSvg = None

#: Pictures of a PDF: the worst neighbours.
MOST_PICTURES = 3
PICTURE = (1200, 750)
#: Widths of the graph and of pictures on A4 with its margins, in pixels of Qt's text documents.
WIDTH, PICTURE_WIDTH = 600, 460
_GRAPH = re.compile(r'<svg class="graph".*?</svg>', re.S)
#: What only a screen can do.
_SCREEN = re.compile(r'<span class="screen">.*?</span>', re.S)


def take_pictures(obj, report):
    """[(caption, media type, bytes)] of the worst places, as the document's view shows them."""
    gui = Gui.getDocument(obj.Document.Name)
    view = gui.ActiveView if gui is not None else None
    if view is None or not hasattr(view, "saveImage"):
        return []
    found, camera, proxy = [], view.getCamera(), obj.ViewObject.Proxy
    shown = obj.ViewObject.Visibility
    folder = tempfile.mkdtemp()
    path = os.path.join(folder, "view.png")
    try:
        obj.ViewObject.Visibility = True
        for index in clearance_table.worst_rows(report)[:MOST_PICTURES]:
            proxy.show_row(obj, index)
            view.saveImage(path, *PICTURE, "White")
            with open(path, "rb") as file:
                found.append((report["neighbours"][index]["name"], "image/png", file.read()))
    finally:
        proxy.hide_row()
        view.setCamera(camera)
        obj.ViewObject.Visibility = shown
        if os.path.exists(path):
            os.remove(path)
        os.rmdir(folder)
    return found


def _graph_image(svg):
    drawing = QtSvg.QSvgRenderer(QtCore.QByteArray(svg.encode("utf-8")))
    image = QtGui.QImage(drawing.defaultSize() * 2, QtGui.QImage.Format_RGB32)
    image.fill(QtCore.Qt.white)
    painter = QtGui.QPainter(image)
    drawing.render(painter)
    painter.end()
    return image


def _for_qt(text, document):
    """The HTML that Qt's text documents know. The graph becomes a picture of the document; pictures need
    both sides."""
    text = _SCREEN.sub("", text)
    found = _GRAPH.search(text)
    sides = (PICTURE_WIDTH, PICTURE_WIDTH * PICTURE[1] // PICTURE[0])
    text = text.replace("<img ", '<img width="{}" height="{}" '.format(*sides))
    if found is not None and QtSvg is not None:
        image = _graph_image(found.group(0))
        document.addResource(QtGui.QTextDocument.ImageResource, QtCore.QUrl("graph.png"), image)
        shown = '<img src="graph.png" width="{}" height="{}" />'
        shown = shown.format(WIDTH, WIDTH * image.height() // image.width())
        text = text.replace(found.group(0), shown)
    for unknown, known in (("figure", "div"), ("figcaption", "p")):
        text = text.replace("<" + unknown + ">", "<" + known + ">")
        text = text.replace("</" + unknown + ">", "</" + known + ">")
    return text


def pdf_of(text):
    """Any thread: the bytes of a PDF on A4 from the page of the template "print"."""
    document = QtGui.QTextDocument()
    document.setHtml(_for_qt(text, document))
    content = QtCore.QByteArray()
    target = QtCore.QBuffer(content)
    target.open(QtCore.QIODevice.WriteOnly)
    writer = QtGui.QPdfWriter(target)
    margins = QtCore.QMarginsF()  # the text document has some of its own
    size = QtGui.QPageSize(QtGui.QPageSize.A4)
    upright, unit = QtGui.QPageLayout.Portrait, QtGui.QPageLayout.Millimeter
    writer.setPageLayout(QtGui.QPageLayout(size, upright, margins, unit))
    writer.setCreator("Swept Volume")
    writer.setTitle(document.metaInformation(QtGui.QTextDocument.DocumentTitle))
    document.print_(writer)
    del writer  # what is not yet written is
    target.close()
    return bytes(content.data())


class PageTask(Task):
    """Writes the report of a clearance check; the document stays as it is."""

    writes = False

    def __init__(self, obj, path):
        self.title = translate("Messages", "Export report")
        self.document = obj.Document
        self.watched = [obj]
        self.path = path
        page.check_target(path)
        self.request = page.request(obj, bool(Gui.getDocument(obj.Document.Name).Modified))
        wanted = page.is_pdf(path) or not core.has_page_view()
        self.pictures = take_pictures(obj, self.request.report) if wanted else []

    def work(self, control):
        if not page.is_pdf(self.path):
            return page.text(self.request, control, pictures=self.pictures).encode("utf-8")
        layout = core.page_template("print")
        return pdf_of(page.text(self.request, control, layout, self.pictures, view=False))

    def finish(self, value):
        with written_beside(self.path) as beside, open(beside, "wb") as out:
            out.write(value)
        App.Console.PrintMessage(
            translate("Messages", "Written: {0} ({1})\n").format(
                self.path, quantities.megabytes(len(value))
            )
        )
