// SPDX-License-Identifier: MIT
// The scene's context: one for all strokes, ticked once a frame, before they update.
using UnityEngine;

namespace Filigree.Samples
{
    [DefaultExecutionOrder(-100)]
    public sealed class FiligreeRunner : MonoBehaviour
    {
        [Tooltip("Threads that the SDK works on between frames. 0: all work is done in Update, within the budget.")]
        public int workers = 1;

        [Tooltip("Microseconds that a frame may spend in the SDK.")]
        public int budgetUs = 500;

        public FiligreeContext Context { get; private set; }

        void Awake()
        {
            Context = new FiligreeContext(workers, 0, Log);
        }

        void Update()
        {
            Context.Tick(budgetUs);
        }

        void OnDestroy()
        {
            if (Context != null) Context.Dispose();
        }

        static void Log(FlgLogLevel level, string message)
        {
            if (level == FlgLogLevel.Error) Debug.LogError(message);
            else if (level == FlgLogLevel.Warning) Debug.LogWarning(message);
            else Debug.Log(message);
        }
    }
}
