#lang racket/base
;; The result of a test file, as the process that runs it writes it down.

(provide (struct-out result))

;; passed, failed : numbers of checks
;; skips   : reasons, strings
;; ending  : a text that says how the file ended if not properly, or #f
;; seconds : on the clock
;; files   : short names of our files whose modules it loaded
(struct result (passed failed skips ending seconds files) #:prefab)
