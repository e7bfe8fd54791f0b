// SPDX-License-Identifier: MIT
// Runs the wrappers over objects that remember what they were asked (godot_sharp.cs). Prints what is wrong; ends with code 1 if something is.
using System;
using Godot;
using GrassAddon;

static class CheckWrappers
{
    private static int _wrong;

    private static void Check(bool holds, string what)
    {
        if (!holds)
        {
            Console.WriteLine("wrong: " + what);
            _wrong++;
        }
    }

    private static string Refusal(Action action)
    {
        try
        {
            action();
        }
        catch (Exception error)
        {
            return error.GetType().Name + ": " + error.Message;
        }
        return "";
    }

    private static GodotObject MakeObject(string name)
    {
        switch (name)
        {
            case "GrassField":
                return new GeometryInstance3D { Native = name };
            case "GrassWorld":
                return new Node3D { Native = name };
            default:
                return name.StartsWith("Grass") ? new Resource { Native = name } : null;
        }
    }

    private static void CheckProperties()
    {
        GrassField field = new GrassField { Density = 12.5f, CollisionMask = 0x80000000, SleepMode = GrassField.SleepModeEnum.Timer };
        GodotObject inside = field.Instance;
        Check(inside.Values["density"].AsSingle() == 12.5f && field.Density == 12.5f, "a number");
        Check(inside.Values["collision_mask"].AsInt64() == 2147483648L && field.CollisionMask == 0x80000000, "a mask has no sign");
        Check(inside.Values["sleep_mode"].AsInt64() == 0 && field.SleepMode == GrassField.SleepModeEnum.Timer, "an enum");
        Check(field.Map == null, "no map");
        field.Map = new GrassMap();
        Check(inside.Values["map"].AsGodotObject().GetClass() == "GrassMap" && field.Map == field.Map, "a map");
        field.Map = null;
        Check(field.Map == null, "no map any more");
        Check(field.Species.Length == 0, "no species");
        field.Species = new[] { new GrassSpecies { Share = 0.25f }, null };
        Check(field.Species.Length == 2 && field.Species[0].Share == 0.25f && field.Species[1] == null, "species");
    }

    private static void CheckMethods()
    {
        GrassField field = new GrassField();
        GodotObject inside = field.Instance;
        inside.Set("bake_ground", 5000000000L);
        Check(field.BakeGround() == 5000000000L && inside.Arguments[1].AsInt64() == 4294967295L, "counts are large, a mask is whole");
        field.Blast(new Vector3(1, 2, 3));
        Check(inside.Arguments.Length == 4 && inside.Arguments[1].AsSingle() == 20.0f && inside.Arguments[0].AsVector3().Z == 3, "defaults");
        inside.Set("get_mown_share", 0.5f);
        Check(field.GetMownShare() == 0.5f && inside.Arguments[0].AsGodotObject() == null, "no shape");
        Check(inside.Arguments[1].AsTransform3D().IsIdentity, "a transform that is left out is the identity");
        field.GetMownShare(null, default(Transform3D));
        Check(!inside.Arguments[1].AsTransform3D().IsIdentity, "a transform that is given");
        GrassMap map = new GrassMap();
        map.Instance.Set("sample", 0.75f);
        Check(map.Sample(GrassMap.Channel.Ground, new Vector2(1, 2)) == 0.75f && map.Instance.Arguments[0].AsInt64() == 5, "an enum is a number");
        Check(GrassField.GetVersion() == "static" && ClassDB.Called[0] == "GrassField.get_version", "a static method");
    }

    private static void CheckEvents()
    {
        Node3D node = new Node3D { Native = "GrassWorld" };
        int heard = 0;
        GrassField last = null;
        Action<Vector2I, GrassField> listen = (plot, field) =>
        {
            heard += plot.X;
            last = field;
        };
        GrassWorld.Bind(node).PlotLoaded += listen;
        GeometryInstance3D inside = new GeometryInstance3D { Native = "GrassField" };
        node.Emit("plot_loaded", new Vector2I(3, 1), inside);
        Check(heard == 3 && last == GrassField.Bind(inside), "an event with its field");
        GrassWorld.Bind(node).PlotLoaded -= listen; // by another wrapper of the same node
        Check(node.Connected.Count == 0, "no handler is left");
        GrassWorld.Bind(node).PlotLoaded -= listen;
        node.Emit("plot_loaded", new Vector2I(3, 1), inside);
        Check(heard == 3, "a handler that was taken away");
    }

    private static void CheckBinding()
    {
        Node3D node = new Node3D { Native = "GrassWorld" };
        Check(GrassWorld.Bind(node) == GrassWorld.Bind(node) && GrassWorld.Bind(node).Equals((object)GrassWorld.Bind(node)), "equal");
        Check(GrassWorld.Bind(node) != GrassWorld.Bind(new Node3D { Native = "GrassWorld" }) && GrassWorld.Bind(node) != null, "different");
        Check(Refusal(() => GrassField.Bind(node)) == "ArgumentException: Bind() needs a GrassField, and got a GrassWorld.", "another class");
        Check(Refusal(() => GrassField.Bind(null)) == "ArgumentException: Bind() needs a GrassField, and got null.", "null");
        Check(!GrassField.TryBind(node, out GrassField none) && none == null && !GrassField.TryBind(null, out none), "nothing to bind");
        Check(GrassWorld.TryBind(node, out GrassWorld world) && world.Instance == node, "bound");
        node.IsFreed = true;
        Check(!world.IsValid, "freed");
        Node parent = new Node();
        GrassField field = new GrassField();
        parent.AddChild(field);
        Check(parent.Children[0] == field.Instance, "a wrapper goes where the engine takes a node");
        Variant variant = (GrassField)null;
        Check(variant.AsGodotObject() == null, "null stays null");
        ClassDB.Maker = name => null;
        Check(Refusal(() => new GrassField()).Contains("the library of addons/grass_field is not loaded"), "without the library");
        Check(Refusal(() => GrassField.Bind(node)).Contains("the library of addons/grass_field is not loaded"), "a placeholder");
    }

    private static int Main()
    {
        ClassDB.Maker = MakeObject;
        CheckProperties();
        CheckMethods();
        CheckEvents();
        CheckBinding();
        return _wrong > 0 ? 1 : 0;
    }
}
