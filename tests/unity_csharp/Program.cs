// SPDX-License-Identifier: MIT
// The binding under Mono: one test a run, by name, with the files that it reads.
using System;

namespace Filigree.Tests
{
    static class Program
    {
        static int Main(string[] arguments)
        {
            try
            {
                Run(arguments);
                return 0;
            }
            catch (Exception failure)
            {
                Console.Error.WriteLine(failure);
                return 1;
            }
        }

        static void Run(string[] arguments)
        {
            switch (arguments[0])
            {
                case "layout": LayoutTests.EqualsThatOfC(arguments[1]); break;
                case "bits": BitTests.EqualThoseOfC(arguments[1]); break;
                case "garbage": GarbageTests.ThereIsNone(); break;
                case "errors": ErrorTests.Run(); break;
                case "classes": ClassTests.Run(); break;
                case "domain": DomainTests.TakeTheirContextsAlong(); break;
                case "callbacks": CallbackTests.Run(); break;
                case "host_jobs": HostJobTests.EqualThoseOfWorkers(); break;
                case "sample": SampleTests.Run(); break;
                default: throw new ArgumentException("no test " + arguments[0]);
            }
        }
    }
}
