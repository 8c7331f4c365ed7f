"""Types and docstrings: what editors and help() show is what there is."""

import ast
import inspect
import pathlib
import re
import unittest

import ocelli
from ocelli import _ocelli

STUB = ast.parse((pathlib.Path(ocelli.__file__).parent / "_ocelli.pyi").read_text(encoding="utf-8"))
PUBLIC_MODULES = (ocelli, ocelli.camera, ocelli.devices, ocelli.effects, ocelli.ocri, ocelli.scene, ocelli.sea, ocelli.study)


def stub_functions(body):
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def stub_arguments(node):
    """Names of the arguments, but for self."""
    names = [each.arg for each in node.args.args + node.args.kwonlyargs]
    return [name for name in names if name != "self"]


def own_arguments(function):
    """Names of a pybind11 function's arguments, of the signature in its docstring; those without a name are arg0, ..."""
    line = function.__doc__.splitlines()[0]
    return [name for name in re.findall(r"(\w+): ", line.split(") ->")[0]) if name != "self"]


def public_functions():
    for module in PUBLIC_MODULES:
        for name in module.__all__:
            if inspect.isfunction(function := getattr(module, name)):
                yield f"{module.__name__}.{name}", function


class Types(unittest.TestCase):
    def test_the_stub_names_what_there_is(self):
        there = {name for name in vars(_ocelli) if not name.startswith("__")}
        classes = {node.name for node in STUB.body if isinstance(node, ast.ClassDef)}
        self.assertEqual(there - classes - set(stub_functions(STUB.body)), set())
        self.assertEqual((classes | set(stub_functions(STUB.body))) - there, set())

    def test_functions_of_the_stub_have_the_arguments_that_there_are(self):
        for name, node in stub_functions(STUB.body).items():
            function = getattr(_ocelli, name)
            named = own_arguments(function)
            with self.subTest(name):
                self.assertEqual(len(stub_arguments(node)), len(named))
                if not any(each.startswith("arg") for each in named):
                    self.assertEqual(stub_arguments(node), named)

    def test_classes_of_the_stub_have_the_members_that_there_are(self):
        for node in STUB.body:
            if not isinstance(node, ast.ClassDef):
                continue
            there = {name for name in vars(getattr(_ocelli, node.name)) if not name.startswith("_")}
            with self.subTest(node.name):
                self.assertEqual({name for name in stub_functions(node.body) if not name.startswith("_")}, there)

    def test_members_say_what_they_are(self):
        self_explaining = {"width", "height", "name", "frame", "view", "wraps_around"}
        for name in ocelli.__all__:
            kind = getattr(ocelli, name)
            if not inspect.isclass(kind) or kind.__module__ != "ocelli._ocelli":
                continue
            self.assertTrue(kind.__doc__, name)
            for member, value in vars(kind).items():
                if not member.startswith("_") and member not in self_explaining:
                    text = inspect.getdoc(value) or ""
                    with self.subTest(f"{name}.{member}"):
                        self.assertGreater(len([line for line in text.splitlines() if "->" not in line and line.strip()]), 0)

    def test_public_functions_have_types_and_docstrings(self):
        found = dict(public_functions())
        self.assertIn("ocelli.render", found)
        for name, function in found.items():
            with self.subTest(name):
                self.assertTrue(function.__doc__)
                signature = inspect.signature(function)
                self.assertIsNot(signature.return_annotation, inspect.Signature.empty)
                for parameter in signature.parameters.values():
                    self.assertIsNot(parameter.annotation, inspect.Parameter.empty, parameter.name)
                    if parameter.kind is not inspect.Parameter.VAR_KEYWORD and len(signature.parameters) > 2:
                        self.assertIn(f"{parameter.name}:", function.__doc__)

    def test_modules_show_their_own_alone(self):
        for module in PUBLIC_MODULES[1:]:
            for name in module.__all__:
                each = getattr(module, name)
                self.assertIn(getattr(each, "__module__", None), (module.__name__, "ocelli._ocelli", "ocelli._table"), name)


if __name__ == "__main__":
    unittest.main()
